#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/scene/slices.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/volume/cells.h"
#include "gl/brick_window.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/render_options.h"

namespace vvr::gl {

/// A brick or a standing frame.
struct DrawnPart {
    bool is_frame = false;
    std::size_t number = 0;  ///< index of the brick or the frame

    friend bool operator==(const DrawnPart&, const DrawnPart&) = default;
};

/// Back-to-front order of a window's bricks and standing frames, seen from `from`.
/// \param bricks in time order; may be empty
/// \param standing t_C of each frame, in any order; a frame within a brick is drawn at the brick's nearer end
std::vector<DrawnPart> drawing_order(const space::Layout& layout, const glm::dvec3& from,
                                     std::span<const volume::PlacedCells> bricks, std::span<const double> standing);

/// Standing frames, drawn between the bricks.
struct StandingFrames {
    std::vector<double> times{};                     ///< t_C of each
    std::function<void(std::size_t number)> draw{};  ///< may change any OpenGL state except the framebuffer
};

/// Draws the window's bricks as view-aligned slices, back to front, one draw call per brick; the fragment shader
/// computes the layout's inverse map (§5.1, §6.1).
class VolumeSlicer {
  public:
    /// \param colour VolumeColour::own needs bricks with colours, VolumeColour::object bricks with identities
    VolumeSlicer(const GladGLContext& gl, const space::Layout& layout, VolumeColour colour, VolumeShading shading);

    void set_transfer(const scene::TransferFunction& transfer);

    /// Sets the palette. For VolumeColour::object it has the colour of each identity and, as alpha, a factor on its
    /// extinction. For VolumeColour::time it has 256 colours, from the first frame to the last.
    void set_palette(std::span<const glm::vec4> palette);

    void draw(BrickWindow& window, const space::Camera& camera, const scene::SliceStack& stack,
              const StandingFrames& standing = {});

    /// Draws into a pixel data target. Frames are counted from the window's first.
    /// \param frames_per_layer of the volume
    void draw_pixel_data(BrickWindow& window, const space::Camera& camera, const scene::SliceStack& stack,
                         std::int64_t frames_per_layer, const PixelDataTarget& target, const StandingFrames& standing);

  private:
    /// Binds the state that all bricks share.
    void use(const Program& program, const space::Camera& camera, const scene::SliceStack& stack) const;

    /// Visits bricks and standing frames back to front: cuts and binds each brick, then calls `draw` with its index in
    /// the window and its mesh.
    void for_each_brick(const Program& program, BrickWindow& window, const space::Camera& camera,
                        const scene::SliceStack& stack, const StandingFrames& standing,
                        const std::function<void(std::size_t, const scene::SliceMesh&)>& draw);

    const GladGLContext* gl_;
    const space::Layout* layout_;
    VolumeColour colour_;
    Program program_;
    std::optional<Program> pixel_data_program_;  ///< compiled on first use
    scene::TransferFunction transfer_;
    GlTexture transfer_texture_;
    GlTexture palette_texture_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_;
    GlBuffer indices_;
};

}  // namespace vvr::gl
