#include "cli/app/drawing.h"

#include <algorithm>
#include <numbers>

#include "cli/app/build_scene.h"
#include "core/scene/hues.h"
#include "core/scene/object_looks.h"
#include "core/scene/slices.h"
#include "gl/framebuffer.h"

namespace vvr {

namespace {

// A clip in which a point moves, of sizes that are no powers of two, like most: Mesa makes other shaders for those.
constexpr Size rehearsed_size{6, 6};
constexpr int rehearsed_frames = 5;

Volume rehearsed_volume(VolumeColour colour) {
    Volume volume(rehearsed_size, rehearsed_frames);
    if (colour == VolumeColour::object) volume.keep_owners();
    const Plane<Bgr> picture = colour == VolumeColour::own ? Plane<Bgr>(rehearsed_size) : Plane<Bgr>();
    for (int i = 0; i < rehearsed_frames; ++i) {
        Field field{i, i / 25.0, Plane<std::uint8_t>(rehearsed_size), {}, {{2, 2, 1, 1}}};
        field.scalar.at(2, 2) = 255;
        volume.add(field, picture);
    }
    return volume;
}

}  // namespace

void open_context(const RenderJob& job, Drawing& drawing, Observer& observer) {
    const auto warn = [&observer](const std::string& text) { observer.warn(text); };
    drawing.context =
        open_context(job.backend.name, job.backend.device, job.backend.debug ? DriverMessages(warn) : DriverMessages());
    check_samples(drawing.context->gl(), job.picture.samples);
}

void make_renderer(const RenderJob& job, Size field_size, std::int64_t tile_samples, Drawing& drawing) {
    drawing.layout = layout_of(job, field_size);
    drawing.framing = frame_volume(job, *drawing.layout, static_cast<double>(field_size.width) / field_size.height);
    RenderOptions options = job.picture;
    options.camera = drawing.framing.camera;
    options.background = background_of(job.look);
    options.glyphs = glyph_style_of(job);
    options.tile_samples = tile_samples;
    drawing.renderer = std::make_unique<Renderer>(*drawing.context, *drawing.layout, options);
    drawing.renderer->set_transfer(drawn_transfer_of(job.look));
    if (job.picture.colour == VolumeColour::object) drawing.renderer->set_looks(looks_of(job.look.theme));
    if (job.picture.colour == VolumeColour::time) drawing.renderer->set_looks(time_colours());
}

double half_pixel(const RenderJob& job, const Drawing& drawing) {
    double side = 0;
    for (const glm::dvec3& p : outline_points(*drawing.layout))
        side = std::max(side, drawing.framing.camera.pixel_side(p, job.picture.size));
    return side * std::numbers::sqrt2 / 2;
}

void rehearse(const RenderJob& job, const Drawing& drawing) {
    const Volume volume = rehearsed_volume(job.picture.colour);
    const Frame frame{0, 0, Plane<std::uint8_t>(rehearsed_size), {}};
    BrickWindow window(drawing.context->gl(), *drawing.layout, rehearsed_frames, 1);
    if (job.look.show.has(Part::volume)) window.show(volume, cut_into(rehearsed_frames, 1));
    Renderer& renderer = *drawing.renderer;
    renderer.set_scene(build_scene(job, volume, {frame, frame}, *drawing.layout, drawing.framing, {}, {}));
    renderer.rehearse(window);
}

}  // namespace vvr
