#include "gl/renderer.h"

#include <algorithm>
#include <future>
#include <limits>
#include <utility>

#include <oneapi/tbb/parallel_for.h>

#include "core/scene/overlay.h"
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
      textures_(context.gl(), BrickRing(options.ring)),
      slicer_(context.gl(), layout, options.colour, options.shading),
      flow_geometry_(context.gl()),
      traceline_strips_(context.gl()),
      annotations_(context.gl()) {}

void Renderer::set_window(int ring, std::int64_t layers) {
    window_.clear();
    options_.ring = ring;
    options_.window_layers = layers;
    textures_ = BrickTextures(*gl_, BrickRing(ring));
}

void Renderer::push_brick(std::int64_t number, const BrickLayers& layers) {
    auto cells = std::async(std::launch::async, [&] { return brick_cells(layers, t_span(layers), *layout_); });
    textures_.upload(number, layers);
    if (static_cast<int>(window_.size()) == options_.ring) window_.erase(window_.begin());
    window_.push_back({number, layers.brick().count, layers.size(), layers.box(), cells.get(), {}});
}

void Renderer::drop_before(std::int64_t number) {
    std::erase_if(window_, [number](const Held& held) { return held.number < number; });
}

void Renderer::show(const Volume& volume, std::span<const Brick> bricks, int textures) {
    set_window(textures, volume.layers());
    window_.resize(bricks.size());
    oneapi::tbb::parallel_for(std::size_t{0}, bricks.size(), [&](std::size_t i) {
        const BrickLayers layers(volume, bricks[i]);
        window_[i] = {static_cast<std::int64_t>(i),
                      layers.brick().count,
                      layers.size(),
                      layers.box(),
                      brick_cells(layers, t_span(layers), *layout_),
                      layers};
    });
}

void Renderer::renew_ends(std::int64_t number, const BrickLayers& layers) {
    textures_.upload_ends(number, layers);
    const auto held = std::ranges::find(window_, number, &Held::number);
    held->box = layers.box();
    held->cells = brick_cells(layers, t_span(layers), *layout_);
}

double Renderer::t_span(const BrickLayers& layers) const {
    return static_cast<double>(layers.brick().count) / static_cast<double>(options_.window_layers);
}

std::vector<PlacedBrick> Renderer::place() const {
    std::vector<PlacedBrick> placed;
    std::int64_t before = 0;
    const auto n = static_cast<double>(options_.window_layers);
    for (const Held& brick : window_) {
        const double t_begin = static_cast<double>(before) / n;
        before += brick.layers;
        placed.push_back({brick.number, brick.layers, t_begin, static_cast<double>(before) / n, brick.size, brick.box,
                          &brick.cells, brick.made_of ? &*brick.made_of : nullptr});
    }
    return placed;
}

void Renderer::set_scene(Scene scene) {
    scene_ = std::move(scene);
    flow_geometry_.upload(scene_.arrows);
    traceline_strips_.upload(scene_.tracelines);
    annotations_.upload(scene_.floor, scene_.frames);
}

SliceStack Renderer::slices(const Camera& camera) const {
    // Two rows of a frame: half as many slices as rows look the same, as filters leave nothing thinner than that.
    const double spacing = window_.empty() ? 1 : 2 * layout_->shape().y_s / window_.front().size.height;
    return stack_slices(camera, *layout_, options_.slices, spacing);
}

Plane<glm::vec4> Renderer::draw(double phase) {
    const SliceStack stack = slices(camera_);
    auto picture = Plane<glm::vec4>::for_overwrite(options_.size);
    for (const Tile& tile : tiles_) {
        draw_tile(stack, phase, tile);
        framebuffer_.read(tile, picture);
    }
    return picture;
}

PixelData Renderer::draw_layers(const TimeTable& times) {
    if (!seen_) seen_.emplace(*gl_, tiles_.front().size);
    const SliceStack stack = slices(camera_);
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    PixelData layers{Plane<float>(options_.size, none), Plane<float>(options_.size, none),
                     Plane<float>(options_.size, -1)};
    for (const Tile& tile : tiles_) {
        const Plane<glm::vec4> seen = draw_tile_seen(stack, times.frames_a_layer(), tile);
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

Plane<glm::vec4> Renderer::draw_tile_seen(const SliceStack& stack, std::int64_t frames_a_layer, const Tile& tile) {
    const GladGLContext& gl = *gl_;
    const Camera camera = camera_.cropped(tile, options_.size);
    seen_->begin(tile.size);
    flow_geometry_.draw_seen(camera, options_.glyphs);
    traceline_strips_.draw_seen(camera, tile.size, options_.traces);
    const Plane<glm::vec4> opaque = seen_->read(tile.size);
    seen_->begin_before_geometry();
    slicer_.draw_seen(place(), textures_, camera, stack, frames_a_layer, *seen_);
    for (const StandingFrame& frame : scene_.frames) annotations_.draw_frame_seen(frame, *layout_, camera, *seen_);
    Plane<glm::vec4> seen = seen_->read(tile.size);
    check_gl(gl, "drawing the layers");
    std::ranges::transform(opaque.pixels(), seen.pixels(), seen.pixels().begin(),
                           [](const glm::vec4& behind, const glm::vec4& before) {
                               return behind.w > 0 && before.w <= 0.5F ? behind : before;
                           });
    return seen;
}

void Renderer::draw_unread(double phase) {
    const SliceStack stack = slices(camera_);
    for (const Tile& tile : tiles_) draw_tile(stack, phase, tile);
    gl_->Finish();
}

void Renderer::rehearse() {
    const Tile corner{.size = {std::min(16, options_.size.width), std::min(16, options_.size.height)}};
    draw_tile(slices(camera_), 0, corner);
    Plane<glm::vec4> unseen(corner.size);
    framebuffer_.read(corner, unseen);
}

void Renderer::draw_tile(const SliceStack& stack, double phase, const Tile& tile) {
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
    slicer_.draw(place(), textures_, camera, stack);
    annotations_.draw_frames(scene_.frames, *layout_, camera);
    check_gl(gl, "drawing the picture");
}

}  // namespace vvr
