#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/fields/blobs.h"
#include "core/fields/field.h"

namespace vvr::volume {

/// A sparse picture: stores only the tiles with non-zero pixels. The scalars of a layer are 0 wherever nothing moves;
/// for a typical street scene, a twentieth of the tiles is stored.
template <class T>
class Sparse {
  public:
    Sparse() = default;
    explicit Sparse(Size size);  ///< all pixels are 0
    explicit Sparse(const Plane<T>& whole);

    Size size() const { return size_; }
    bool empty() const { return size_ == Size{}; }  ///< whether the size is 0, not whether all pixels are 0

    T at(int i, int j) const {
        const Tile* const tile = tile_at(tile_index(i, j));
        return tile == nullptr ? T{} : (*tile)[within(i, j)];
    }

    /// Sets a pixel. Allocates its tile if needed.
    void set(int i, int j, T value);

    T greatest() const;

    /// The bounding box of the stored tiles. All pixels outside are 0.
    PixelBox box() const;

    /// The number of non-zero pixels.
    std::int64_t count() const;

    /// Allocates memory for the tiles that another picture of the same size has and this one lacks, and no more: in a
    /// long clip, most layers are not extended again.
    void reserve_for(const Sparse& other);

    /// Sets each pixel to the maximum of itself and that of a picture of the same size.
    void keep_maximum(const Sparse& other);

    /// Calls visit(column, row, values) for each row of each stored tile. All other pixels are 0.
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

    /// The number of pixels that are non-zero in at least one of two pictures of the same size.
    template <class U>
    friend std::int64_t count_union(const Sparse<U>& a, const Sparse<U>& b);

    /// Whether all pixels are equal.
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
    int across_ = 0;                  ///< tiles per row
    std::vector<std::int32_t> held_;  ///< index in `tiles_` per tile position, or none; row by row from the top
    std::vector<Tile> tiles_;
};

using SparsePlane = Sparse<std::uint8_t>;

/// The owner of each pixel: a number of `Owners`; 0 = none.
using OwnerPlane = Sparse<std::uint16_t>;

/// One layer of the volume. Each pixel merges its values in `frames` consecutive frames; for strengths, that is the
/// maximum.
struct Layer {
    std::int64_t first_frame = 0;  ///< index in the clip
    std::int64_t last_frame = 0;
    std::int64_t frames = 0;
    double pts = 0;            ///< time of the first frame, seconds
    double last_pts = 0;       ///< time of the last frame, seconds
    std::int64_t missing = 0;  ///< number of missing frames among `frames`
    std::int64_t moving = 0;   ///< number of frames with motion, if known
    SparsePlane scalar;
    Plane<Bgr> colour;  ///< from the frame of each scalar; empty unless colours are added
    OwnerPlane owner;   ///< from the frame of each scalar; empty unless owners are kept
};

/// Merges a layer with the next one. Each voxel keeps the colour and owner of the greater value, or of the first if
/// both are equal.
/// \param values kind of values, which determines how two values merge
void merge(Layer& layer, const Layer& next, fields::Values values = fields::Values::strength);

/// Decides which neighbouring layers are merged when layers have unequal lengths, so that motion gets more layers.
class LayerMerger {
  public:
    /// \param values kind of values, which determines how two values merge
    explicit LayerMerger(fields::Values values) : values_(values) {}

    /// Call it after a layer was appended.
    void add(const std::vector<Layer>& layers);

    /// Call it after layers have changed.
    void restart(const std::vector<Layer>& layers);

    /// Merges two neighbours: the shortest two without motion if more than `idle` layers have none, else the two with
    /// the smallest loss.
    /// \param idle number of layers without motion to keep, if possible
    /// \param decided the first layers, of which it is known whether they have motion
    void merge_cheapest(std::vector<Layer>& layers, std::size_t idle, std::size_t decided);

    /// Merges the shortest two neighbours without motion among the first `decided` layers.
    /// \returns false if there are none
    bool merge_idle(std::vector<Layer>& layers, std::size_t decided);

  private:
    void merge_at(std::vector<Layer>& layers, std::size_t i);

    fields::Values values_;

    std::vector<double> losses_;  ///< of each layer with the next one
};

/// Whether a layer has no frame with motion.
inline bool is_idle(const Layer& layer) {
    return layer.moving == 0;
}

/// The optical flow at some frames of the window: a vector field over (column, row, frame), which tracelines follow
/// (§5.2). Stored as half floats, whose 11 bits exceed the accuracy of optical flow.
class FlowVolume {
  public:
    /// Adds the flow of `frame`, which must be later than the previous ones. All flows have the same size.
    void add(std::int64_t frame, const fields::Flow& flow);

    /// Removes the frames for which `gone` returns true.
    void erase_if(const std::function<bool(std::int64_t)>& gone);

    /// Removes the frames before `frame`, which becomes frame 0.
    void drop_front(std::int64_t frame);

    bool empty() const { return layers_.empty(); }
    std::size_t layers() const { return layers_.size(); }
    std::size_t bytes() const;

    /// (u, v) in field pixels per frame at (column, row, frame). Interpolates linearly between pixel centres and
    /// between stored frames, and is constant beyond them. Zero if no frame is stored.
    glm::dvec2 at(const glm::dvec3& point) const;

  private:
    struct Layer {
        std::int64_t frame = 0;
        Plane<std::uint32_t> packed;  ///< u in the low 16 bits, v in the high 16 bits
    };

    std::vector<Layer> layers_;
};

}  // namespace vvr::volume
