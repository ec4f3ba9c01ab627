#include "gl/renderer.h"

#include <algorithm>

#include "core/scene/slices.h"
#include "gl/check.h"

namespace vvr {

Renderer::Renderer(const Context& context, const Layout& layout, const RenderOptions& options)
    : gl_(&context.gl()),
      layout_(&layout),
      options_(options),
      camera_(fit_camera(options.view, outline_points(layout), options.size)),
      framebuffer_(context.gl(), options.size, options.samples),
      textures_(context.gl(), BrickRing(options.ring)),
      slicer_(context.gl(), layout),
      flow_geometry_(context.gl()),
      annotations_(context.gl(), options.size) {}

void Renderer::push_brick(std::int64_t number, const BrickTexels& texels) {
    textures_.upload(number, texels);
    const double t_span = static_cast<double>(texels.brick.count) / static_cast<double>(options_.window_layers);
    if (static_cast<int>(window_.size()) == options_.ring) window_.erase(window_.begin());
    window_.push_back({number, texels.brick.count, brick_cells(texels, t_span, *layout_)});
}

std::vector<PlacedBrick> Renderer::place() const {
    std::vector<PlacedBrick> placed;
    std::int64_t before = 0;
    const auto n = static_cast<double>(options_.window_layers);
    for (const Held& brick : window_) {
        const double t_begin = static_cast<double>(before) / n;
        before += brick.layers;
        placed.push_back({brick.number, brick.layers, t_begin, static_cast<double>(before) / n, &brick.cells});
    }
    return placed;
}

Plane<glm::vec4> Renderer::draw(const Scene& scene) {
    const GladGLContext& gl = *gl_;
    framebuffer_.bind();
    gl.ClearColor(options_.background.x, options_.background.y, options_.background.z, 1);
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    annotations_.draw_lines(scene.outline, camera_, 1.0 + options_.size.height / 800.0);
    flow_geometry_.draw(scene.arrows, camera_, options_.glyphs);

    const std::vector<PlacedBrick> bricks = place();
    // One voxel of the frame's rows: the finest that the data hold in two of the three directions.
    const double voxel = bricks.empty() ? 1 : layout_->shape().y_s / (bricks.front().cells->ny() * 16.0);
    slicer_.draw(bricks, textures_, camera_, stack_slices(camera_, *layout_, options_.slices, voxel));

    for (const StandingFrame& frame : scene.frames) annotations_.draw_frame(frame, *layout_, camera_);
    check_gl(gl, "drawing the picture");
    return framebuffer_.read();
}

}  // namespace vvr
