#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/fields/tiles.h"
#include "core/pixel_box.h"
#include "core/plane.h"

namespace vvr {

/// A picture that is 0 in most places, as the scalars of a layer are where nothing moves: only tiles in which something
/// isn't 0 are held. Of a street that is a twentieth.
class SparsePlane {
  public:
    SparsePlane() = default;
    explicit SparsePlane(const Plane<std::uint8_t>& whole);

    Size size() const { return size_; }
    bool empty() const { return size_ == Size{}; }  ///< it has no pixels; not: all of them are 0

    std::uint8_t at(int i, int j) const;
    std::uint8_t greatest() const;

    /// Where the tiles lie that are held: all around is 0. Empty when none is.
    PixelBox box() const;

    /// Takes on the pixels of a picture of the same size that are greater than its own.
    void keep_greater(const SparsePlane& other);

    /// Calls visit(column, row, values) for each row of each tile that is held: what isn't visited is 0.
    template <class Visit>
    void each_run(const Visit& visit) const {
        for (std::size_t place = 0; place < held_.size(); ++place) {
            const Tile* const tile = tile_at(place);
            if (tile == nullptr) continue;
            const PixelBox box = box_of(place);
            std::span<const std::uint8_t> rows = *tile;
            for (int row = box.top; row < box.bottom; ++row, rows = rows.subspan(tile_side)) {
                visit(box.left, row, rows.first(static_cast<std::size_t>(box.width())));
            }
        }
    }

    /// The same pixels.
    friend bool operator==(const SparsePlane& a, const SparsePlane& b);

  private:
    static constexpr std::int32_t none = -1;
    using Tile = std::array<std::uint8_t, tile_side * tile_side>;

    PixelBox box_of(std::size_t place) const;
    const Tile* tile_at(std::size_t place) const;

    Size size_;
    int across_ = 0;                  ///< places in a row of them
    std::vector<std::int32_t> held_;  ///< of each place the tile that lies there, or none; places in rows from the top
    std::vector<Tile> tiles_;
};

}  // namespace vvr
