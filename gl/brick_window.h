#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/bricks/brick.h"
#include "core/bricks/brick_layers.h"
#include "core/bricks/cells.h"
#include "core/space/layout.h"
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

/// Texture coordinates from C-space: scale and offset.
struct TextureMap {
    glm::vec3 scale;
    glm::vec3 offset;
};

/// The bricks that are drawn, in the order of time, and their textures (§6.1). Before each picture `show` says which
/// bricks these are. A brick keeps its texture and its cells while it stays in the window.
class BrickWindow {
  public:
    /// \param layout outlives the window
    /// \param layers that fill all of t_C; fewer fill its beginning
    /// \param textures at least 1. With fewer textures than bricks, bricks take them in turn in each drawing.
    /// \param margin of the cells, see brick_cells
    BrickWindow(const GladGLContext& gl, const space::Layout& layout, std::int64_t layers, int textures,
                double margin = 0);

    /// Replaces the bricks of the window.
    ///
    /// A brick that stays gets new end layers where a neighbour came or went. So a window that has moved draws the same
    /// bytes as a new one.
    /// \param volume stays as it is until the bricks have been drawn
    /// \param bricks each follows the one before it
    /// \param first number of the first brick. A brick has the same number each time it is shown.
    /// \param identify stays as `volume` does. A brick that has a texture keeps the identities that it was laid out
    ///        with.
    void show(const bricks::Volume& volume, std::span<const bricks::Brick> bricks, std::int64_t first = 0,
              const bricks::Identify& identify = bricks::no_identities);

    /// Where the bricks lie in t_C, with their cells.
    std::span<const bricks::PlacedCells> cells() const { return placed_; }

    /// The layers of brick `i` of the window.
    const bricks::BrickLayers& layers(std::size_t i) const { return shown_[i].layers; }

    /// Where brick `i` lies in its texture.
    TextureMap texture_map(std::size_t i) const;

    /// Binds the texture of brick `i` to the active texture unit, and uploads the brick if it has none.
    /// \throws Error limit when the driver can't hold the brick
    void bind(std::size_t i) { textures_.bind(shown_[i].number, shown_[i].layers); }

  private:
    struct Shown {
        std::int64_t number;
        bricks::BrickLayers layers;
        bricks::BrickCells cells;
    };

    double t_span(const bricks::BrickLayers& layers) const;

    const space::Layout* layout_;
    double window_layers_;
    double margin_;
    BrickTextures textures_;
    std::vector<Shown> shown_;
    std::vector<bricks::PlacedCells> placed_;  ///< of `shown_`
};

}  // namespace vvr::gl
