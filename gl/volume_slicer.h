#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/bricks/cells.h"
#include "core/scene/slices.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "gl/brick_window.h"
#include "gl/framebuffer.h"
#include "gl/program.h"
#include "gl/render_options.h"

namespace vvr::gl {

/// A brick, or a picture that stands in the volume.
struct DrawnPart {
    bool stands = false;
    std::size_t number = 0;  ///< of the brick or the picture

    friend bool operator==(const DrawnPart&, const DrawnPart&) = default;
};

/// The bricks of a window and the pictures that stand in it, farthest from `from` first: a picture is drawn between its
/// neighbours, so that it hides what is behind it, and is hidden by what is before it.
/// \param bricks in the order of time; may be none
/// \param standing t_C of each picture, in any order; where it lies within a brick it is drawn at the nearer end
std::vector<DrawnPart> drawing_order(const space::Layout& layout, const glm::dvec3& from,
                                     std::span<const bricks::PlacedCells> bricks, std::span<const double> standing);

/// Pictures that stand in the volume, which are drawn between its bricks.
struct StandingPictures {
    std::vector<double> times{};                     ///< t_C of each
    std::function<void(std::size_t number)> draw{};  ///< may change all state of OpenGL but the framebuffer
};

/// Draws the window's bricks as view-aligned slices, back to front, with the layout's backward map in the fragment
/// shader (§5.1, §6.1): one draw call per brick, in visibility order.
class VolumeSlicer {
  public:
    /// \param colour for VolumeColour::own the bricks have colours, for VolumeColour::object identities
    VolumeSlicer(const GladGLContext& gl, const space::Layout& layout, VolumeColour colour, VolumeShading shading);

    void set_transfer(const scene::TransferFunction& transfer);

    /// What the identities look like: colour, and a factor on the extinction. Or the colours of time, 256 of them. For
    /// sources of colour that use a palette.
    void set_palette(std::span<const glm::vec4> palette);

    void draw(BrickWindow& window, const space::Camera& camera, const scene::SliceStack& stack,
              const StandingPictures& standing = {});

    /// Draws into a target of pixel data. Frames are counted from the window's first.
    /// \param frames_per_layer of the volume
    void draw_pixel_data(BrickWindow& window, const space::Camera& camera, const scene::SliceStack& stack,
                         std::int64_t frames_per_layer, const PixelDataTarget& target,
                         const StandingPictures& standing);

  private:
    /// What all bricks are drawn with, but for the textures of their own.
    void use(const Program& program, const space::Camera& camera, const scene::SliceStack& stack) const;

    /// Cuts and binds each brick, back to front, and calls `draw` with its number in the window and its mesh; between
    /// them the standing pictures.
    void for_each_brick(const Program& program, BrickWindow& window, const space::Camera& camera,
                        const scene::SliceStack& stack, const StandingPictures& standing,
                        const std::function<void(std::size_t, const scene::SliceMesh&)>& draw);

    const GladGLContext* gl_;
    const space::Layout* layout_;
    VolumeColour colour_;
    Program program_;
    std::optional<Program> pixel_data_program_;  ///< made when it is first used
    scene::TransferFunction transfer_;
    GlTexture transfer_texture_;
    GlTexture palette_texture_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_;
    GlBuffer indices_;
};

}  // namespace vvr::gl
