#include "gl/renderer.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/scene/slices.h"

namespace vvr::gl {

namespace {

// A pixel below this opacity shows nothing.
constexpr float min_opacity = 1.0F / 255;

/// Converts a depth buffer value, 0..1, to the distance along the view direction.
double distance_of(double depth, const space::Camera& camera) {
    const double ndc = 2 * depth - 1;
    const double scale = camera.projection[2][2];
    const double offset = camera.projection[3][2];
    return camera.perspective ? offset / (ndc - scale) : (ndc - offset) / scale;
}

}  // namespace

Renderer::Renderer(const Context& context, const space::Layout& layout, const RenderOptions& options)
    : gl_(&context.gl()),
      layout_(&layout),
      options_(options),
      camera_(options.camera.value_or(space::fit_camera(options.view, scene::outline_points(layout), options.size))),
      tiles_(cut_tiles(options.size, options.tile_samples / options.samples)),
      framebuffer_(context.gl(), tiles_.front().size(), options.samples),
      slicer_(context.gl(), layout, options.colour, options.shading),
      flow_geometry_(context.gl()),
      traceline_strips_(context.gl()),
      annotations_(context.gl()) {}

void Renderer::set_scene(scene::Scene scene) {
    scene_ = std::move(scene);
    flow_geometry_.upload(scene_.arrows);
    traceline_strips_.upload(scene_.tracelines);
    annotations_.upload(scene_.floor, scene_.frames);
}

scene::SliceStack Renderer::slices(const BrickWindow& window, const space::Camera& camera) const {
    // Two rows of a frame: filters leave nothing thinner, so half as many slices look the same.
    const double spacing = window.cells().empty() ? 1 : 2 * layout_->shape().y_s / window.layers(0).size().height;
    return scene::stack_slices(camera, *layout_, options_.slices, spacing);
}

Plane<glm::vec4> Renderer::draw(BrickWindow& window, double phase, const TileCallback& drawn) {
    auto picture = Plane<glm::vec4>::for_overwrite(options_.size);
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        draw_tile(window, tiles_[i], phase);
        framebuffer_.read(tiles_[i], picture);
        if (drawn) drawn(i + 1, tiles_.size());
    }
    return picture;
}

image::PixelData Renderer::draw_pixel_data(BrickWindow& window, const scene::TimeTable& times,
                                           const TileCallback& drawn) {
    if (!pixel_data_) pixel_data_.emplace(*gl_, tiles_.front().size());
    constexpr float none = std::numeric_limits<float>::quiet_NaN();
    image::PixelData shown{
        Plane<float>(options_.size, none), Plane<float>(options_.size, none), Plane<float>(options_.size, -1), {}};
    const bool with_objects = options_.colour == VolumeColour::object;
    if (with_objects) shown.object = Plane<float>(options_.size);
    for (std::size_t k = 0; k < tiles_.size(); ++k) {
        const PixelBox& tile = tiles_[k];
        const auto [data, objects] = draw_tile_data(window, tile, times.frames_per_layer());
        for (int j = 0; j < tile.height(); ++j) {
            for (int i = 0; i < tile.width(); ++i) {
                const glm::vec4& pixel = data.at(i, j);
                if (pixel.w < min_opacity) continue;
                const Moment at = times.at(static_cast<double>(pixel.y));
                shown.depth.at(tile.left + i, tile.top + j) = static_cast<float>(distance_of(pixel.z, camera_));
                shown.time.at(tile.left + i, tile.top + j) = static_cast<float>(at.seconds);
                shown.frame.at(tile.left + i, tile.top + j) = static_cast<float>(at.frame);
                if (with_objects) shown.object.at(tile.left + i, tile.top + j) = objects.at(i, j).x;
            }
        }
        if (drawn) drawn(k + 1, tiles_.size());
    }
    return shown;
}

Renderer::TileData Renderer::draw_tile_data(BrickWindow& window, const PixelBox& tile, std::int64_t frames_per_layer) {
    const space::Camera camera = camera_.cropped(tile, options_.size);
    pixel_data_->begin(tile.size());
    flow_geometry_.draw_pixel_data(camera, options_.glyphs);
    traceline_strips_.draw_pixel_data(camera, tile.size(), options_.traces, options_.glyphs);
    const Plane<glm::vec4> opaque = pixel_data_->read(tile.size());
    pixel_data_->begin_before_geometry();
    const StandingFrames frames{
        frame_times(),
        [&](std::size_t i) { annotations_.draw_frame_pixel_data(scene_.frames[i], *layout_, camera, *pixel_data_); }};
    slicer_.draw_pixel_data(window, camera, slices(window, camera_), frames_per_layer, *pixel_data_, frames);
    TileData tile_data{pixel_data_->read(tile.size()), pixel_data_->read_objects(tile.size())};
    check_gl(*gl_, "drawing the pixel data");
    for (std::size_t i = 0; i < opaque.pixels().size(); ++i) {
        const glm::vec4& behind = opaque.pixels()[i];
        glm::vec4& in_front = tile_data.data.pixels()[i];
        if (behind.w <= 0 || in_front.w > 0.5F) continue;
        in_front = behind;
        tile_data.objects.pixels()[i] = glm::vec4(0);
    }
    return tile_data;
}

std::vector<double> Renderer::frame_times() const {
    std::vector<double> times;
    for (const scene::StandingFrame& frame : scene_.frames) times.push_back(frame.t);
    return times;
}

void Renderer::warm_up(BrickWindow& window) {
    const PixelBox corner{0, 0, std::min(16, options_.size.width), std::min(16, options_.size.height)};
    draw_tile(window, corner);
    Plane<glm::vec4> unused(corner.size());
    framebuffer_.read(corner, unused);
}

void Renderer::draw_tile(BrickWindow& window, const PixelBox& tile, double phase) {
    const GladGLContext& gl = *gl_;
    const space::Camera camera = camera_.cropped(tile, options_.size);
    framebuffer_.bind(tile.size());
    gl.ClearColor(options_.background.x, options_.background.y, options_.background.z, options_.background.w);
    gl.DepthMask(GL_TRUE);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);

    annotations_.draw_lines(scene_.lines, camera, 1.0 + options_.size.height / 800.0, tile.size());
    // From below the floor should come last, but it is too faint for this to show.
    annotations_.draw_floor(scene_.floor, *layout_, camera);
    flow_geometry_.draw(camera, options_.glyphs);
    traceline_strips_.draw(camera, tile.size(), options_.traces, options_.glyphs, phase);
    const StandingFrames frames{frame_times(),
                                [&](std::size_t i) { annotations_.draw_frame(scene_.frames[i], i, *layout_, camera); }};
    slicer_.draw(window, camera, slices(window, camera_), frames);
    check_gl(gl, "drawing the picture");
}

}  // namespace vvr::gl
