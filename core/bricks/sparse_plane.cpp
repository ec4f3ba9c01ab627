#include "core/bricks/sparse_plane.h"

#include <algorithm>
#include <functional>

namespace vvr {

SparsePlane::SparsePlane(const Plane<std::uint8_t>& whole) : size_(whole.size()) {
    const Plane<std::uint8_t> occupied = occupied_tiles(whole);
    across_ = occupied.width();
    held_.assign(occupied.pixels().size(), none);
    tiles_.reserve(static_cast<std::size_t>(std::ranges::count(occupied.pixels(), std::uint8_t{1})));
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (occupied.pixels()[place] == 0) continue;
        held_[place] = static_cast<std::int32_t>(tiles_.size());
        const PixelBox box = box_of(place);
        auto into = tiles_.emplace_back().begin();
        for (int row = box.top; row < box.bottom; ++row, into += tile_side) {
            std::ranges::copy_n(whole.row(row).begin() + box.left, box.width(), into);
        }
    }
}

PixelBox SparsePlane::box_of(std::size_t place) const {
    const int left = static_cast<int>(place) % across_ * tile_side;
    const int top = static_cast<int>(place) / across_ * tile_side;
    return {left, top, std::min(left + tile_side, size_.width), std::min(top + tile_side, size_.height)};
}

const SparsePlane::Tile* SparsePlane::tile_at(std::size_t place) const {
    return held_[place] == none ? nullptr : &tiles_[static_cast<std::size_t>(held_[place])];
}

std::uint8_t SparsePlane::at(int i, int j) const {
    const Tile* const tile = tile_at(static_cast<std::size_t>(j / tile_side * across_ + i / tile_side));
    return tile == nullptr ? 0 : (*tile)[static_cast<std::size_t>(j % tile_side * tile_side + i % tile_side)];
}

std::uint8_t SparsePlane::greatest() const {
    std::uint8_t greatest = 0;
    for (const Tile& tile : tiles_) greatest = std::max(greatest, std::ranges::max(tile));
    return greatest;
}

PixelBox SparsePlane::box() const {
    PixelBox box;
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (held_[place] != none) box = hull_of(box, box_of(place));
    }
    return box;
}

void SparsePlane::keep_greater(const SparsePlane& other) {
    // Room for what is added and no more: in a long clip it is added to most layers a last time.
    std::size_t added_tiles = 0;
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (held_[place] == none && other.held_[place] != none) ++added_tiles;
    }
    tiles_.reserve(tiles_.size() + added_tiles);
    for (std::size_t place = 0; place < held_.size(); ++place) {
        const Tile* const added = other.tile_at(place);
        if (added == nullptr) continue;
        if (held_[place] == none) {
            held_[place] = static_cast<std::int32_t>(tiles_.size());
            tiles_.push_back(*added);
        } else {
            Tile& kept = tiles_[static_cast<std::size_t>(held_[place])];
            std::ranges::transform(kept, *added, kept.begin(), std::ranges::max);
        }
    }
}

bool operator==(const SparsePlane& a, const SparsePlane& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t place = 0; place < a.held_.size(); ++place) {
        const SparsePlane::Tile* const in_a = a.tile_at(place);
        const SparsePlane::Tile* const in_b = b.tile_at(place);
        if ((in_a == nullptr) != (in_b == nullptr) || (in_a != nullptr && *in_a != *in_b)) return false;
    }
    return true;
}

}  // namespace vvr
