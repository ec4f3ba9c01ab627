#include "gl/renderer.h"

#include <algorithm>
#include <utility>

#include "core/scene/overlay.h"
#include "core/scene/slices.h"
#include "gl/check.h"

namespace vvr {

namespace {

// A tile of so many samples takes 20 bytes a sample: the framebuffer's memory doesn't grow with the picture.
constexpr std::int64_t tile_samples = 1536 * 1024;

std::vector<glm::dvec3> points_to_hold(const Layout& layout, bool box) {
    std::vector<glm::dvec3> points = outline_points(layout);
    if (box) points = corners(layout_box(layout));
    return points;
}

}  // namespace

Renderer::Renderer(const Context& context, const Layout& layout, const RenderOptions& options)
    : gl_(&context.gl()),
      layout_(&layout),
      options_(options),
      camera_(fit_camera(options.view, points_to_hold(layout, options.hold_box), options.size)),
      tiles_(cut_tiles(options.size, tile_samples / options.samples)),
      framebuffer_(context.gl(), tiles_.front().size, options.samples),
      textures_(context.gl(), BrickRing(options.ring)),
      slicer_(context.gl(), layout, options.colour),
      flow_geometry_(context.gl()),
      traceline_strips_(context.gl()),
      annotations_(context.gl()) {}

void Renderer::push_brick(std::int64_t number, const BrickTexels& texels) {
    textures_.upload(number, texels);
    if (static_cast<int>(window_.size()) == options_.ring) window_.erase(window_.begin());
    window_.push_back({number, texels.brick.count, texels.size, brick_cells(texels, t_span(texels), *layout_)});
}

void Renderer::renew_ends(std::int64_t number, const BrickTexels& texels) {
    textures_.upload_ends(number, texels);
    const auto held = std::ranges::find(window_, number, &Held::number);
    held->cells = brick_cells(texels, t_span(texels), *layout_);
}

double Renderer::t_span(const BrickTexels& texels) const {
    return static_cast<double>(texels.brick.count) / static_cast<double>(options_.window_layers);
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

void Renderer::set_scene(Scene scene) {
    scene_ = std::move(scene);
    flow_geometry_.upload(scene_.arrows);
    traceline_strips_.upload(scene_.tracelines);
}

SliceStack Renderer::slices(const Camera& camera) const {
    // Two rows of a frame: half as many slices as rows look the same, as filters leave nothing thinner than that.
    const double spacing = window_.empty() ? 1 : 2 * layout_->shape().y_s / window_.front().size.height;
    return stack_slices(camera, *layout_, options_.slices, spacing);
}

Plane<glm::vec4> Renderer::draw(double phase) {
    const SliceStack stack = slices(camera_);
    Plane<glm::vec4> picture(options_.size);
    for (const Tile& tile : tiles_) {
        draw_tile(stack, phase, tile);
        const Plane<glm::vec4> drawn = framebuffer_.read(tile.size);
        for (int j = 0; j < tile.size.height; ++j) {
            std::ranges::copy(drawn.row(j), picture.row(tile.row + j).begin() + tile.column);
        }
    }
    return picture;
}

void Renderer::draw_unread(double phase) {
    const SliceStack stack = slices(camera_);
    for (const Tile& tile : tiles_) draw_tile(stack, phase, tile);
    gl_->Finish();
}

void Renderer::draw_tile(const SliceStack& stack, double phase, const Tile& tile) {
    const GladGLContext& gl = *gl_;
    const Camera camera = camera_.cropped(tile, options_.size);
    framebuffer_.bind(tile.size);
    gl.ClearColor(options_.background.x, options_.background.y, options_.background.z, 1);
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    annotations_.draw_lines(scene_.lines, camera, 1.0 + options_.size.height / 800.0, tile.size);
    flow_geometry_.draw(camera, options_.glyphs);
    traceline_strips_.draw(camera, tile.size, options_.traces, options_.glyphs, phase);
    slicer_.draw(place(), textures_, camera, stack);
    for (const StandingFrame& frame : scene_.frames) annotations_.draw_frame(frame, *layout_, camera);
    check_gl(gl, "drawing the picture");
}

}  // namespace vvr
