#include "gl/renderer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/scene/slices.h"
#include "gl/check.h"

namespace vvr {

namespace {

// A pixel that lets more than this of what is behind it through shows nothing.
constexpr float least_opacity = 1.0F / 255;

/// The distance along the view direction of what has `depth`, 0..1, in the depth buffer.
double distance_of(double depth, const Camera& camera) {
    const double ndc = 2 * depth - 1;
    const double scale = camera.projection[2][2];
    const double offset = camera.projection[3][2];
    return camera.perspective ? offset / (ndc - scale) : (ndc - offset) / scale;
}

}  // namespace

Renderer::Renderer(const Context& context, const Layout& layout, const RenderOptions& options)
    : gl_(&context.gl()),
      layout_(&layout),
      options_(options),
      camera_(options.camera.value_or(fit_camera(options.view, outline_points(layout), options.size))),
      tiles_(cut_tiles(options.size, options.tile_samples / options.samples)),
      framebuffer_(context.gl(), tiles_.front().size, options.samples),
      slicer_(context.gl(), layout, options.colour, options.shading),
      flow_geometry_(context.gl()),
      traceline_strips_(context.gl()),
      annotations_(context.gl()) {}

void Renderer::set_scene(Scene scene) {
    scene_ = std::move(scene);
    flow_geometry_.upload(scene_.arrows);
    traceline_strips_.upload(scene_.tracelines);
    annotations_.upload(scene_.floor, scene_.frames);
}

SliceStack Renderer::slices(const BrickWindow& window, const Camera& camera) const {
    // Two rows of a frame: half as many slices as rows look the same, as filters leave nothing thinner than that.
    const double spacing =
        window.cells().empty() ? 1 : 2 * layout_->shape().y_s / window.layers(0).size().height;
    return stack_slices(camera, *layout_, options_.slices, spacing);
}

Plane<glm::vec4> Renderer::draw(BrickWindow& window, double phase) {
    auto picture = Plane<glm::vec4>::for_overwrite(options_.size);
    for (const Tile& tile : tiles_) {
        draw_tile(window, tile, phase);
        framebuffer_.read(tile, picture);
    }
    return picture;
}

PictureLayers Renderer::draw_layers(BrickWindow& window, const TimeTable& times) {
    if (!seen_) seen_.emplace(*gl_, tiles_.front().size);
    const SliceStack stack = slices(window, camera_);
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    PictureLayers layers{Plane<float>(options_.size, none), Plane<float>(options_.size, none),
                         Plane<float>(options_.size, -1)};
    for (const Tile& tile : tiles_) {
        const Plane<glm::vec4> seen = draw_tile_seen(window, stack, times.frames_a_layer(), tile);
        for (int j = 0; j < tile.size.height; ++j) {
            for (int i = 0; i < tile.size.width; ++i) {
                const glm::vec4& state = seen.at(i, j);
                if (state.w < least_opacity) continue;
                const FrameTime at = times.at(static_cast<double>(state.y));
                layers.depth.at(tile.column + i, tile.row + j) = static_cast<float>(distance_of(state.z, camera_));
                layers.time.at(tile.column + i, tile.row + j) = static_cast<float>(at.seconds);
                layers.frame.at(tile.column + i, tile.row + j) = static_cast<float>(at.frame);
            }
        }
    }
    return layers;
}

Plane<glm::vec4> Renderer::draw_tile_seen(BrickWindow& window, const SliceStack& stack,
                                          std::int64_t frames_a_layer, const Tile& tile) {
    const GladGLContext& gl = *gl_;
    const Camera camera = camera_.cropped(tile, options_.size);
    seen_->begin(tile.size);
    flow_geometry_.draw_seen(camera, options_.glyphs);
    traceline_strips_.draw_seen(camera, tile.size, options_.traces);
    const Plane<glm::vec4> opaque = seen_->read(tile.size);
    seen_->begin_before_geometry();
    slicer_.draw_seen(window, camera, stack, frames_a_layer, *seen_);
    for (const StandingFrame& frame : scene_.frames) annotations_.draw_frame_seen(frame, *layout_, camera, *seen_);
    Plane<glm::vec4> seen = seen_->read(tile.size);
    check_gl(gl, "drawing the layers");
    std::ranges::transform(opaque.pixels(), seen.pixels(), seen.pixels().begin(),
                           [](const glm::vec4& behind, const glm::vec4& before) {
                               return behind.w > 0 && before.w <= 0.5F ? behind : before;
                           });
    return seen;
}

void Renderer::rehearse(BrickWindow& window) {
    const Tile corner{.size = {std::min(16, options_.size.width), std::min(16, options_.size.height)}};
    draw_tile(window, corner);
    Plane<glm::vec4> unseen(corner.size);
    framebuffer_.read(corner, unseen);
}

void Renderer::draw_tile(BrickWindow& window, const Tile& tile, double phase) {
    const GladGLContext& gl = *gl_;
    const Camera camera = camera_.cropped(tile, options_.size);
    framebuffer_.bind(tile.size);
    gl.ClearColor(options_.background.x, options_.background.y, options_.background.z, options_.background.w);
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    annotations_.draw_lines(scene_.lines, camera, 1.0 + options_.size.height / 800.0, tile.size);
    // Seen from below, the floor lies before all else, and is drawn as what is behind it all the same: it is thin.
    annotations_.draw_floor(scene_.floor, *layout_, camera);
    flow_geometry_.draw(camera, options_.glyphs);
    traceline_strips_.draw(camera, tile.size, options_.traces, options_.glyphs, phase);
    slicer_.draw(window, camera, slices(window, camera_));
    annotations_.draw_frames(scene_.frames, *layout_, camera);
    check_gl(gl, "drawing the picture");
}

}  // namespace vvr
