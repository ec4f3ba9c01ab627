#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/blobs.h"
#include "core/fields/field.h"

namespace vvr::bricks {

/// A picture that is 0 in most places, as the scalars of a layer are where nothing moves: only tiles in which something
/// isn't 0 are held. Of a street that is a twentieth.
template <class T>
class Sparse {
  public:
    Sparse() = default;
    explicit Sparse(Size size);  ///< all of it is 0
    explicit Sparse(const Plane<T>& whole);

    Size size() const { return size_; }
    bool empty() const { return size_ == Size{}; }  ///< it has no pixels; not: all of them are 0

    T at(int i, int j) const {
        const Tile* const tile = tile_at(tile_index(i, j));
        return tile == nullptr ? T{} : (*tile)[within(i, j)];
    }

    /// Makes a tile where there is none and the value isn't 0.
    void set(int i, int j, T value);

    T greatest() const;

    /// Where the tiles lie that are held: all around is 0. Empty when none is.
    PixelBox box() const;

    /// How many pixels aren't 0.
    std::int64_t count() const;

    /// Takes on the pixels of a picture of the same size that are greater than its own.
    void keep_maximum(const Sparse& other);

    /// Calls visit(column, row, values) for each row of each tile that is held: what isn't visited is 0.
    template <class Visit>
    void for_each_run(const Visit& visit) const {
        for (std::size_t place = 0; place < held_.size(); ++place) {
            const Tile* const tile = tile_at(place);
            if (tile == nullptr) continue;
            const PixelBox box = box_of(place);
            std::span<const T> rows = *tile;
            for (int row = box.top; row < box.bottom; ++row, rows = rows.subspan(fields::tile_side)) {
                visit(box.left, row, rows.first(static_cast<std::size_t>(box.width())));
            }
        }
    }

    /// How many pixels aren't 0 in one of two pictures of the same size.
    template <class U>
    friend std::int64_t count_union(const Sparse<U>& a, const Sparse<U>& b);

    /// The same pixels.
    template <class U>
    friend bool operator==(const Sparse<U>& a, const Sparse<U>& b);

  private:
    static constexpr std::int32_t none = -1;
    using Tile = std::array<T, fields::tile_side * fields::tile_side>;

    std::size_t tile_index(int i, int j) const {
        return static_cast<std::size_t>(j / fields::tile_side * across_ + i / fields::tile_side);
    }
    static std::size_t within(int i, int j) {
        return static_cast<std::size_t>(j % fields::tile_side * fields::tile_side + i % fields::tile_side);
    }
    PixelBox box_of(std::size_t place) const;
    const Tile* tile_at(std::size_t place) const {
        return held_[place] == none ? nullptr : &tiles_[static_cast<std::size_t>(held_[place])];
    }

    Size size_;
    int across_ = 0;                  ///< places in a row of them
    std::vector<std::int32_t> held_;  ///< of each place the tile that lies there, or none; places in rows from the top
    std::vector<Tile> tiles_;
};

template <class U>
std::int64_t count_union(const Sparse<U>& a, const Sparse<U>& b);

using SparsePlane = Sparse<std::uint8_t>;

/// Whose each pixel is: a number of `Owners`, 0 = nobody's.
using OwnerPlane = Sparse<std::uint16_t>;

/// One layer of the volume: of each pixel what its values in `frames` consecutive frames join to, the strongest one
/// where they are strengths.
struct Layer {
    std::int64_t first_frame = 0;  ///< index in the clip
    std::int64_t last_frame = 0;
    std::int64_t frames = 0;
    double pts = 0;            ///< seconds, of its first frame
    double last_pts = 0;       ///< seconds, of its last frame
    std::int64_t missing = 0;  ///< of the frames, those that never came
    std::int64_t moving = 0;   ///< of the frames, those in which something moves, where that is told
    SparsePlane scalar;
    Plane<Bgr> colour;  ///< of the frame that gave the scalar; empty unless colours are added
    OwnerPlane owner;   ///< in that frame; empty unless owners are kept
};

/// Joins a layer with the one after it; each voxel keeps the colour and the owner of the greater value, the first of
/// two alike.
/// \param values that say how two values join
void join(Layer& layer, const Layer& next, fields::Values values = fields::Values::strength);

/// Pixels times frames in which a layer shows something that was not there, more than its two halves do: what is lost
/// when neighbours become one layer. A layer of n frames in which u pixels are ever occupied shows n·u. Nothing is lost
/// where nothing moves.
double merge_loss(const Layer& a, const Layer& b);

/// Decides which neighbours among layers of unequal length are joined, so that the layers go where something moves.
class LayerMerger {
  public:
    /// \param values what the layers' values are, which says how two join
    explicit LayerMerger(fields::Values values) : values_(values) {}

    /// A layer was added behind the others.
    void add(const std::vector<Layer>& layers);

    /// Joins the two neighbours whose joining loses least. Of those that lose nothing it is the shortest two; and where
    /// only few layers are left for the time in which nothing moves, they stay.
    /// \param idle layers without motion that are to stay, if possible
    void merge_cheapest(std::vector<Layer>& layers, std::size_t idle);

    /// Joins the shortest two neighbours in which nothing moves.
    /// \returns false when there are none
    bool merge_idle(std::vector<Layer>& layers);

  private:
    void merge_at(std::vector<Layer>& layers, std::size_t i);

    fields::Values values_;

    std::vector<double> losses_;  ///< of each layer and the one after it
};

/// Whether nothing moves in a layer.
inline bool is_idle(const Layer& layer) {
    return layer.moving == 0;
}

}  // namespace vvr::bricks
