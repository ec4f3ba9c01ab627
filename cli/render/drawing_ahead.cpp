#include "cli/render/drawing_ahead.h"

#include <exception>
#include <utility>

#include "cli/render/build_scene.h"
#include "core/error.h"

namespace vvr {

namespace {

// A clip in which a point moves, of sizes that are no powers of two, like most: Mesa makes other shaders for those.
constexpr Size rehearsed_size{6, 6};
constexpr int rehearsed_frames = 5;

Volume rehearsed_volume(VolumeColour colour) {
    Volume volume(rehearsed_size, rehearsed_frames);
    const Plane<Bgr> picture = colour == VolumeColour::video ? Plane<Bgr>(rehearsed_size) : Plane<Bgr>();
    for (int i = 0; i < rehearsed_frames; ++i) {
        Field field{i, i / 25.0, Plane<std::uint8_t>(rehearsed_size), {}, {{2, 2, 1, 1}}};
        field.scalar.at(2, 2) = 255;
        volume.add(field, picture);
    }
    return volume;
}

void rehearse(const RenderJob& job, const Drawing& drawing) {
    const Volume volume = rehearsed_volume(job.picture.colour);
    const Frame frame{0, 0, Plane<std::uint8_t>(rehearsed_size), {}};
    Renderer& renderer = *drawing.renderer;
    renderer.set_transfer(job.transfer.scaled(job.opacity));
    if (job.show.contains("volume")) renderer.push_brick(0, BrickLayers(volume, {0, rehearsed_frames}));
    renderer.set_scene(build_scene(job, volume, {frame, frame}, *drawing.layout, drawing.framing));
    renderer.rehearse();
}

}  // namespace

DrawingAhead::DrawingAhead(const RenderJob& job, Size field_size, Part part)
    : job_(&job),
      field_size_(field_size),
      drawing_(std::async(std::launch::async, [this, part] { return open(part); })) {}

DrawingAhead::~DrawingAhead() {
    try {
        if (drawing_.valid()) take();
    } catch (const Error&) {
        // Nobody asked any more.
    }
}

Drawing DrawingAhead::open(Part part) {
    Drawing drawing;
    try {
        drawing.context = open_drawing(*job_);
    } catch (...) {
        opened_.set_exception(std::current_exception());
        throw;
    }
    opened_.set_value();
    if (part == Part::all) {
        make_renderer(drawing, RenderOptions{}.tile_samples);
        rehearse(*job_, drawing);
    }
    drawing.context->release();
    return drawing;
}

void DrawingAhead::make_renderer(Drawing& drawing, std::int64_t tile_samples) const {
    drawing.layout = layout_of(*job_, field_size_);
    drawing.framing = frame_volume(*job_, *drawing.layout);
    RenderOptions options = options_of(*job_, drawing.framing, 1, rehearsed_frames);
    options.tile_samples = tile_samples;
    drawing.renderer = std::make_unique<Renderer>(*drawing.context, *drawing.layout, options);
}

Drawing DrawingAhead::take() {
    Drawing drawing = drawing_.get();
    drawing.context->take();
    if (!drawing.renderer) make_renderer(drawing, RenderOptions{}.tile_samples / 4);
    return drawing;
}

}  // namespace vvr
