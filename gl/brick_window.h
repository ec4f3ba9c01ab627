#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/bricks/brick.h"
#include "core/bricks/brick_layers.h"
#include "core/bricks/cells.h"
#include "core/space/layout.h"
#include "gl/brick_textures.h"

namespace vvr::gl {

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
