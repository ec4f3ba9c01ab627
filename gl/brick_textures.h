#pragma once

#include <cstdint>
#include <vector>

#include "core/base/pixel_box.h"
#include "core/bricks/brick_layers.h"
#include "gl/objects.h"

namespace vvr::gl {

/// 3D textures that hold bricks. A brick that needs one takes a texture that no brick uses, else the one that was taken
/// longest ago.
class BrickTextures {
  public:
    /// \param count of textures, at least 1
    BrickTextures(const GladGLContext& gl, int count);

    /// Binds the texture of brick `number` to the active texture unit. A brick without a texture is uploaded.
    /// \throws Error limit when the brick is larger than the driver's largest 3D texture, or memory is out
    void bind(std::int64_t number, const bricks::BrickLayers& layers);

    /// Uploads a brick, also one that has a texture.
    /// \throws Error as `bind`
    void upload(std::int64_t number, const bricks::BrickLayers& layers);

    /// Uploads the first and the last texel layer of a brick that has a texture: they repeat layers of its neighbours.
    /// All of the brick is uploaded if the box of its layers has changed.
    void update_border_layers(std::int64_t number, const bricks::BrickLayers& layers);

    /// Takes their textures from all bricks but those from `first` to before `end`.
    void keep_only(std::int64_t first, std::int64_t end);

  private:
    static constexpr std::int64_t unused = -1;

    struct Slot {
        GlTexture texture;
        std::int64_t number = unused;  ///< of the brick
        PixelBox box;                  ///< of the layers' texels
        std::int64_t layers = 0;
        bool coloured = false;
    };

    /// The slot of a brick; null if it has none.
    Slot* find(std::int64_t number);

    const GladGLContext* gl_;
    std::vector<Slot> slots_;
    std::size_t next_ = 0;  ///< slot that is taken when none is free
};

}  // namespace vvr::gl
