#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/space/layout.h"
#include "core/volume/brick.h"
#include "core/volume/cells.h"
#include "core/volume/owners.h"
#include "gl/objects.h"

namespace vvr::gl {

/// A pool of 3D textures for bricks. A new brick gets an unused texture, else textures are reused in turn.
class BrickTextures {
  public:
    /// \param count number of textures, at least 1
    BrickTextures(const GladGLContext& gl, int count);

    /// Binds the texture of brick `number` to the active texture unit; uploads the brick first if it has no texture.
    /// \throws Error limit if the brick exceeds the driver's largest 3D texture or memory runs out
    void bind(std::int64_t number, const volume::BrickLayers& layers);

    /// Uploads a brick, even if it has a texture already.
    /// \throws Error as `bind`
    void upload(std::int64_t number, const volume::BrickLayers& layers);

    /// Uploads the first and last texel layers of a brick that has a texture; they repeat layers of its neighbours.
    /// Uploads the whole brick if its bounding box has changed.
    void update_border_layers(std::int64_t number, const volume::BrickLayers& layers);

    /// Frees the textures of all bricks outside the half-open interval [first, end).
    void keep_only(std::int64_t first, std::int64_t end);

  private:
    static constexpr std::int64_t unused = -1;

    struct Slot {
        GlTexture texture;
        std::int64_t number = unused;  ///< brick number
        PixelBox box;                  ///< bounding box of the layers' texels
        std::int64_t layers = 0;
        bool coloured = false;
    };

    /// Null if the brick has no slot.
    Slot* find(std::int64_t number);

    const GladGLContext* gl_;
    std::vector<Slot> slots_;
    std::size_t next_ = 0;  ///< slot to reuse when none is free
};

/// Maps C-space to texture coordinates.
struct TextureMap {
    glm::vec3 scale;
    glm::vec3 offset;
};

/// The bricks that are drawn, in time order, and their textures (§6.1). Call `show` before each picture. A brick keeps
/// its texture and cells while it stays in the window.
class BrickWindow {
  public:
    /// \param layout must outlive the window
    /// \param layers that fill all of t_C; fewer layers fill its beginning
    /// \param textures at least 1. With fewer textures than bricks, each drawing uploads bricks again.
    /// \param margin of the cells, see brick_cells
    BrickWindow(const GladGLContext& gl, const space::Layout& layout, std::int64_t layers, int textures,
                double margin = 0);

    /// Replaces the bricks of the window. A brick that stays gets new border layers where it gained or lost a
    /// neighbour, so a moved window draws the same bytes as a new one.
    /// \param volume must not change until the bricks have been drawn
    /// \param bricks consecutive
    /// \param first number of the first brick. A brick must keep its number from call to call.
    /// \param identify must live as long as `volume`. A brick that keeps its texture keeps its old identities.
    void show(const volume::Volume& volume, std::span<const volume::Brick> bricks, std::int64_t first = 0,
              const volume::VoxelStyleLookup& identify = volume::no_styles);

    /// The bricks' intervals of t_C and their cells.
    std::span<const volume::PlacedCells> cells() const { return placed_; }

    /// `i` is the index in the window.
    const volume::BrickLayers& layers(std::size_t i) const { return shown_[i].layers; }

    /// Maps C-space to the texture of brick `i`.
    TextureMap texture_map(std::size_t i) const;

    /// Binds the texture of brick `i` to the active texture unit; uploads the brick first if it has no texture.
    /// \throws Error limit if the driver can't hold the brick
    void bind(std::size_t i) { textures_.bind(shown_[i].number, shown_[i].layers); }

  private:
    struct Shown {
        std::int64_t number;
        volume::BrickLayers layers;
        volume::BrickCells cells;
    };

    double t_span(const volume::BrickLayers& layers) const;

    const space::Layout* layout_;
    double window_layers_;
    double margin_;
    BrickTextures textures_;
    std::vector<Shown> shown_;
    std::vector<volume::PlacedCells> placed_;  ///< parallel to `shown_`
};

}  // namespace vvr::gl
