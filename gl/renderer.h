#pragma once

#include <cstdint>
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

/// Draws a window of bricks and a scene: opaque geometry first, then the volume back to front with the depth test on
/// (§6.2), so that each hides the other. Frames that stand in the volume are drawn between its bricks: a brick should
/// end where one stands.
class Renderer {
  public:
    /// `context` and `layout` outlive the renderer.
    Renderer(const Context& context, const space::Layout& layout, const RenderOptions& options);

    void set_transfer(const scene::TransferFunction& transfer) { slicer_.set_transfer(transfer); }

    /// As VolumeSlicer::set_palette.
    void set_palette(std::span<const glm::vec4> palette) { slicer_.set_palette(palette); }

    /// Replaces the geometry that is drawn with the bricks.
    void set_scene(scene::Scene scene);

    /// Draws the window's bricks and the scene.
    /// \param phase of the texture that moves along the tracelines, 0..1 (§6.2.1)
    /// \returns premultiplied RGBA, top row first
    Plane<glm::vec4> draw(BrickWindow& window, double phase = 0);

    /// What each pixel of the picture shows at its centre: opaque geometry where it contributes at least as much as all
    /// in front of it, else the sample of the volume, or the standing frame, that contributes most. Lines show no frame
    /// and hide none. This is a pass of its own; `draw` is not affected.
    /// \param times of the frames of the bricks and the scene
    image::PixelData draw_pixel_data(BrickWindow& window, const scene::TimeTable& times);

    /// Draws a tile of the picture, no larger than `tile_samples` allows, and reads nothing back.
    void draw_tile(BrickWindow& window, const PixelBox& tile, double phase = 0);

    /// Draws and reads back a corner of the picture, so that the driver compiles its shaders. Mesa compiles a shader
    /// when it first draws with it.
    void warm_up(BrickWindow& window);

    const space::Camera& camera() const { return camera_; }

    /// The slices that the window's bricks would be cut into for `camera`.
    scene::SliceStack slices(const BrickWindow& window, const space::Camera& camera) const;

  private:
    /// Of a tile: weight, frame, depth, opacity; and events.
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
    std::optional<PixelDataTarget> pixel_data_;  ///< made when it is first drawn
    VolumeSlicer slicer_;
    FlowGeometry flow_geometry_;
    TracelineStrips traceline_strips_;
    Annotations annotations_;
    scene::Scene scene_;
};

}  // namespace vvr::gl
