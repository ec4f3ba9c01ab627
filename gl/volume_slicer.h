#pragma once

#include <span>
#include <vector>

#include "core/bricks/cells.h"
#include "core/scene/slices.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "gl/brick_textures.h"
#include "gl/program.h"

namespace vvr {

/// Draws the window's bricks as view-aligned slices, back to front, with the layout's backward map in the fragment
/// shader (§5.1, §6.1): one draw call a brick, in visibility order.
class VolumeSlicer {
  public:
    VolumeSlicer(const GladGLContext& gl, const Layout& layout);

    void set_transfer(const TransferFunction& transfer);

    /// \param bricks ascending in time
    void draw(std::span<const PlacedBrick> bricks, const BrickTextures& textures, const Camera& camera,
              const SliceStack& stack);

  private:
    const GladGLContext* gl_;
    const Layout* layout_;
    Program program_;
    TransferFunction transfer_;
    GlTexture transfer_texture_;
    GlVertexArray vertex_array_;
    GlBuffer vertices_;
    GlBuffer indices_;
};

}  // namespace vvr
