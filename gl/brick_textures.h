#pragma once

#include <vector>

#include "core/bricks/brick.h"
#include "core/bricks/brick_layers.h"
#include "core/bricks/cells.h"
#include "gl/objects.h"

namespace vvr {

/// The ring's k 3D textures, which bricks take in turn: one that enters overwrites the texture of the one that entered
/// k bricks before (§6.1).
class BrickTextures {
  public:
    BrickTextures(const GladGLContext& gl, BrickRing ring);

    /// Puts a brick into the ring: into the slot that it has, else the next one.
    /// \param number of the brick, counted from the clip's first
    /// \throws Error limit when the brick is larger than the driver's largest 3D texture or memory is out
    void upload(std::int64_t number, const BrickLayers& layers);

    /// Replaces the first and the last texel layer of a brick in the ring, which are its neighbours': they have
    /// changed. If they hold something outside of the brick's box all of it is uploaded.
    void upload_ends(std::int64_t number, const BrickLayers& layers);

    /// Binds a brick's texture to the texture unit in use. If it isn't in the ring it enters.
    /// \throws Error backend when it isn't, and nothing says what it is made of
    void bind(const PlacedBrick& brick);

  private:
    struct Slot {
        GlTexture texture;
        std::int64_t number = -1;
        PixelBox box;  ///< of the layers' texels
        std::int64_t layers = 0;
        bool coloured = false;
    };

    /// Where a brick is in the ring; null if it isn't.
    Slot* find(std::int64_t number);

    const GladGLContext* gl_;
    BrickRing ring_;
    std::vector<Slot> slots_;
    std::int64_t entered_ = 0;  ///< bricks, into the ring
};

}  // namespace vvr
