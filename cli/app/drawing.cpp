#include "cli/app/drawing.h"

#include <algorithm>
#include <numbers>

#include "cli/app/build_scene.h"
#include "core/scene/hues.h"
#include "core/scene/object_looks.h"
#include "core/scene/slices.h"
#include "gl/framebuffer.h"

namespace vvr::app {

namespace {

// A clip in which a point moves, of sizes that are no powers of two, like most: Mesa makes other shaders for those.
constexpr Size rehearsed_size{6, 6};
constexpr int rehearsed_frames = 5;

bricks::Volume warm_up_volume(gl::VolumeColour colour) {
    bricks::Volume volume(rehearsed_size, rehearsed_frames);
    if (colour == gl::VolumeColour::object) volume.keep_owners();
    const Plane<Bgr> picture = colour == gl::VolumeColour::own ? Plane<Bgr>(rehearsed_size) : Plane<Bgr>();
    for (int i = 0; i < rehearsed_frames; ++i) {
        fields::Field field{i, i / 25.0, Plane<std::uint8_t>(rehearsed_size), {}, {{2, 2, 1, 1}}};
        field.scalar.at(2, 2) = 255;
        volume.add(field, picture);
    }
    return volume;
}

}  // namespace

void open_context(const RenderJob& job, Drawing& drawing, Observer& observer) {
    const auto warn = [&observer](const std::string& text) { observer.warn(text); };
    drawing.context = gl::open_context(job.backend.name, job.backend.device,
                                       job.backend.debug ? gl::DriverMessages(warn) : gl::DriverMessages());
    gl::check_samples(drawing.context->gl(), job.picture.samples);
}

void make_renderer(const RenderJob& job, Size field_size, std::int64_t tile_samples, Drawing& drawing) {
    drawing.layout = layout_of(job, field_size);
    drawing.framing = frame_volume(job, *drawing.layout, static_cast<double>(field_size.width) / field_size.height);
    gl::RenderOptions options = job.picture;
    options.camera = drawing.framing.camera;
    options.background = background_of(job.look);
    options.glyphs = glyph_style_of(job);
    options.tile_samples = tile_samples;
    drawing.renderer = std::make_unique<gl::Renderer>(*drawing.context, *drawing.layout, options);
    drawing.renderer->set_transfer(drawn_transfer_of(job.look));
    if (job.picture.colour == gl::VolumeColour::object) drawing.renderer->set_palette(scene::object_palette(job.look.theme));
    if (job.picture.colour == gl::VolumeColour::time) drawing.renderer->set_palette(scene::time_colours());
}

double half_pixel(const RenderJob& job, const Drawing& drawing) {
    double side = 0;
    for (const glm::dvec3& p : scene::outline_points(*drawing.layout))
        side = std::max(side, drawing.framing.camera.pixel_side(p, job.picture.size));
    return side * std::numbers::sqrt2 / 2;
}

void warm_up(const RenderJob& job, const Drawing& drawing) {
    const bricks::Volume volume = warm_up_volume(job.picture.colour);
    const video::Frame frame{0, 0, Plane<std::uint8_t>(rehearsed_size), {}};
    gl::BrickWindow window(drawing.context->gl(), *drawing.layout, rehearsed_frames, 1);
    if (job.look.show.has(Part::volume)) window.show(volume, bricks::cut_into(rehearsed_frames, 1));
    gl::Renderer& renderer = *drawing.renderer;
    renderer.set_scene(build_scene(job, volume, {frame, frame}, *drawing.layout, drawing.framing, {}, {}));
    renderer.warm_up(window);
}

}  // namespace vvr::app
