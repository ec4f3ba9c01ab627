#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/bricks/volume.h"
#include "core/image/picture.h"
#include "core/scene/scene.h"
#include "core/scene/time_table.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "gl/annotations.h"
#include "gl/brick_textures.h"
#include "gl/context.h"
#include "gl/flow_geometry.h"
#include "gl/framebuffer.h"
#include "gl/seen_target.h"
#include "gl/traceline_strips.h"
#include "gl/volume_slicer.h"

namespace vvr {

struct RenderOptions {
    Size size{1280, 800};
    View view;
    std::optional<Camera> camera;         ///< instead of the one that holds the volume from `view`
    int slices = 0;                       ///< 0 = one for every two voxels
    int samples = 4;                      ///< a pixel, for smooth edges; 1 takes about half the time
    std::int64_t tile_samples = 1 << 20;  ///< drawn at a time, 24 bytes each, however large the picture
    int ring = 8;                         ///< k, the bricks that are visible at a time
    std::int64_t window_layers = 0;       ///< n, the layers of a full window
    glm::vec4 background{1, 1, 1, 1};     ///< multiplied by its opacity
    VolumeColour colour = VolumeColour::transfer;
    VolumeShading shading = VolumeShading::none;
    GlyphStyle glyphs;
    TraceStyle traces;
};

/// Draws a window of bricks and its scene: opaque geometry first, then the volume back to front with the depth test
/// on (§6.2), so that each hides the other where it should.
class Renderer {
  public:
    /// `context` and `layout` outlive the renderer.
    Renderer(const Context& context, const Layout& layout, const RenderOptions& options);

    /// Empties the window; from now on it takes `ring` bricks, of `layers` layers when it is full.
    void set_window(int ring, std::int64_t layers);

    void set_transfer(const TransferFunction& transfer) { slicer_.set_transfer(transfer); }

    /// Empties the window and shows a whole volume, which stays as it is until it has been drawn.
    /// \param textures of bricks at a time, at least 1: fewer than there are bricks are made anew in each drawing
    void show(const Volume& volume, std::span<const Brick> bricks, int textures);

    /// Puts brick `number` into the ring and at the end of the window, from which the oldest leaves when it is full.
    void push_brick(std::int64_t number, const BrickLayers& layers);

    /// Takes the bricks of lower numbers out of the window.
    void drop_before(std::int64_t number);

    /// Renews what the texels of a brick in the window repeat of its neighbours, after one has come or gone. So the
    /// window looks as if nothing stood before or after it, and moving it is the same as drawing it afresh.
    void renew_ends(std::int64_t number, const BrickLayers& layers);

    /// Replaces the geometry that is drawn with the bricks.
    void set_scene(Scene scene);

    /// Draws the bricks in the ring and the scene.
    /// \param phase of the texture that moves along the tracelines, 0..1 (§6.2.1)
    /// \returns premultiplied RGBA, top row first
    Plane<glm::vec4> draw(double phase = 0);

    /// What is seen in each pixel of the picture, at its centre: opaque geometry where it contributes at least as much
    /// as all that stands before it, else the sample of the volume, or the standing frame, that contributes most.
    /// Lines show no frame and hide none. It takes a pass of its own, and leaves `draw` as it is.
    /// \param times of the frames of the bricks and the scene
    PixelData draw_layers(const TimeTable& times);

    /// Draws and waits for the end of it, but reads nothing back: what a picture costs that stays on the GPU.
    void draw_unread(double phase = 0);

    /// Draws and reads back a corner of the picture, for nothing but that the driver compiles its shaders, which Mesa
    /// does when it first draws with them.
    void rehearse();

    /// `set_scene` and `draw` in one.
    Plane<glm::vec4> draw(const Scene& scene) {
        set_scene(scene);
        return draw();
    }

    const Camera& camera() const { return camera_; }

    /// The slices that the volume would be cut into for `camera`.
    SliceStack slices(const Camera& camera) const;

    /// Where each brick of the window stands: t_C by its share of the window's layers.
    std::vector<PlacedBrick> place() const;

  private:
    double t_span(const BrickLayers& layers) const;
    Plane<glm::vec4> draw_tile_seen(const SliceStack& stack, std::int64_t frames_a_layer, const Tile& tile);
    void draw_tile(const SliceStack& stack, double phase, const Tile& tile);

    struct Held {
        std::int64_t number = 0;
        std::int64_t layers = 0;
        Size size;  ///< of its layers
        PixelBox box;
        BrickCells cells;
        std::optional<BrickLayers> made_of;  ///< where the texture may have to be made again
    };

    const GladGLContext* gl_;
    const Layout* layout_;
    RenderOptions options_;
    Camera camera_;
    std::vector<Tile> tiles_;
    Framebuffer framebuffer_;
    std::optional<SeenTarget> seen_;  ///< made when layers are first asked for
    BrickTextures textures_;
    VolumeSlicer slicer_;
    FlowGeometry flow_geometry_;
    TracelineStrips traceline_strips_;
    Annotations annotations_;
    std::vector<Held> window_;
    Scene scene_;
};

}  // namespace vvr
