#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/image/picture.h"
#include "core/scene/scene.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "gl/annotations.h"
#include "gl/brick_window.h"
#include "gl/context.h"
#include "gl/flow_geometry.h"
#include "gl/framebuffer.h"
#include "gl/render_options.h"
#include "gl/volume_slicer.h"

namespace vvr::gl {

/// Draws a window of bricks and a scene: opaque geometry first, then the volume back to front with depth test (§6.2),
/// so that each occludes the other. Standing frames are drawn between bricks, so bricks should end at their times.
class Renderer {
  public:
    /// Called after each tile, with the number of those that are drawn and of all.
    using TileCallback = std::function<void(std::size_t done, std::size_t tiles)>;

    /// `context` and `layout` must outlive the renderer.
    Renderer(const Context& context, const space::Layout& layout, const RenderOptions& options);

    void set_transfer(const scene::TransferFunction& transfer) { slicer_.set_transfer(transfer); }

    /// As VolumeSlicer::set_palette.
    void set_palette(std::span<const glm::vec4> palette) { slicer_.set_palette(palette); }

    /// Replaces the geometry drawn with the bricks.
    void set_scene(scene::Scene scene);

    /// Draws the window's bricks and the scene.
    /// \param phase of the texture that moves along the tracelines, 0..1 (§6.2.1)
    /// \param drawn may be empty
    /// \returns premultiplied RGBA, top row first
    Plane<glm::vec4> draw(BrickWindow& window, double phase = 0, const TileCallback& drawn = {});

    /// What each pixel shows at its centre: the opaque geometry if it contributes at least as much as everything in
    /// front of it, else the strongest contribution of the volume or the standing frames. Lines are ignored. This is a
    /// separate pass; `draw` is not affected.
    /// \param times of the frames of the bricks and the scene
    /// \param drawn may be empty
    image::PixelData draw_pixel_data(BrickWindow& window, const scene::TimeTable& times,
                                     const TileCallback& drawn = {});

    /// Draws a tile of at most `tile_samples` samples without reading it back.
    void draw_tile(BrickWindow& window, const PixelBox& tile, double phase = 0);

    /// Draws and reads back a corner of the picture, because Mesa compiles shaders on first use.
    void warm_up(BrickWindow& window);

    const space::Camera& camera() const { return camera_; }

    /// The slices of the window's bricks for `camera`.
    scene::SliceStack slices(const BrickWindow& window, const space::Camera& camera) const;

  private:
    /// Weight, frame, depth and opacity of a tile's pixels; and their event numbers.
    struct TileData {
        Plane<glm::vec4> data;
        Plane<glm::vec4> objects;
    };

    std::vector<double> frame_times() const;
    TileData draw_tile_data(BrickWindow& window, const PixelBox& tile, std::int64_t frames_per_layer);

    const GladGLContext* gl_;
    const space::Layout* layout_;
    RenderOptions options_;
    space::Camera camera_;
    std::vector<PixelBox> tiles_;
    Framebuffer framebuffer_;
    std::optional<PixelDataTarget> pixel_data_;  ///< allocated on first use
    VolumeSlicer slicer_;
    FlowGeometry flow_geometry_;
    TracelineStrips traceline_strips_;
    Annotations annotations_;
    scene::Scene scene_;
};

}  // namespace vvr::gl
