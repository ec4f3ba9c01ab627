#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/scene/slices.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "gl/brick_window.h"
#include "gl/program.h"
#include "gl/seen_target.h"

namespace vvr {

/// Where the volume's colour comes from; extinction is always the transfer function's.
enum class VolumeColour { transfer, video };

struct VolumeColourRow {
    VolumeColour colour;
    std::string_view name;
    std::string_view help;
    std::string_view shader;  ///< defines optical_of(voxel)
};

/// The sources of colour there are; the first is the default.
std::span<const VolumeColourRow> volume_colours();

/// How light falls on the volume.
enum class VolumeShading { none, relief };

struct VolumeShadingRow {
    VolumeShading shading;
    std::string_view name;
    std::string_view help;
    std::string_view shader;  ///< defines shaded(colour)
};

/// The ways there are; the first is the default.
std::span<const VolumeShadingRow> volume_shadings();

/// Draws the window's bricks as view-aligned slices, back to front, with the layout's backward map in the fragment
/// shader (§5.1, §6.1): one draw call a brick, in visibility order.
class VolumeSlicer {
  public:
    /// \param colour for VolumeColour::video the bricks are coloured ones
    VolumeSlicer(const GladGLContext& gl, const Layout& layout, VolumeColour colour, VolumeShading shading);

    void set_transfer(const TransferFunction& transfer);

    void draw(BrickWindow& window, const Camera& camera, const SliceStack& stack);

    /// The same into a target of what is seen: frames are counted from the window's first.
    /// \param frames_a_layer of the volume
    void draw_seen(BrickWindow& window, const Camera& camera, const SliceStack& stack, std::int64_t frames_a_layer,
                   const SeenTarget& target);

  private:
    /// Cuts and binds each brick, back to front, and calls `draw` with its number in the window and its mesh.
    void for_each_brick(const Program& program, BrickWindow& window, const Camera& camera, const SliceStack& stack,
                        const std::function<void(std::size_t, const SliceMesh&)>& draw);

    const GladGLContext* gl_;
    const Layout* layout_;
    VolumeColour colour_;
    Program program_;
    std::optional<Program> seen_program_;  ///< made when it is first asked for
    TransferFunction transfer_;
    GlTexture transfer_texture_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_;
    GlBuffer indices_;
};

}  // namespace vvr
