#pragma once

#include <vector>

#include "core/bricks/brick.h"
#include "core/bricks/brick_layers.h"
#include "gl/objects.h"

namespace vvr {

/// The ring's k 3D textures. A brick that enters overwrites the texture of the one that has left (§6.1).
class BrickTextures {
  public:
    BrickTextures(const GladGLContext& gl, BrickRing ring);

    /// Puts a brick into its slot of the ring.
    /// \param number of the brick, counted from the clip's first
    /// \throws Error limit when the brick is larger than the driver's largest 3D texture or memory is out
    void upload(std::int64_t number, const BrickLayers& layers);

    /// Replaces the first and the last texel layer of a brick in the ring, which are its neighbours': they have
    /// changed. If they hold something outside of the brick's box all of it is uploaded.
    void upload_ends(std::int64_t number, const BrickLayers& layers);

    /// Binds the texture that holds brick `number` to the texture unit in use.
    void bind(std::int64_t number) const;

  private:
    struct Slot {
        GlTexture texture;
        std::int64_t number = -1;
        PixelBox box;  ///< of the layers' texels
        std::int64_t layers = 0;
        bool coloured = false;
    };

    const Slot& slot_of(std::int64_t number) const;

    const GladGLContext* gl_;
    BrickRing ring_;
    std::vector<Slot> slots_;
};

}  // namespace vvr
