#include "core/bricks/sparse_plane.h"

#include <algorithm>
#include <functional>

namespace vvr::bricks {

template <class T>
Sparse<T>::Sparse(Size size)
    : size_(size),
      across_((size.width + fields::tile_side - 1) / fields::tile_side),
      held_(static_cast<std::size_t>(across_) *
                static_cast<std::size_t>((size.height + fields::tile_side - 1) / fields::tile_side),
            none) {}

template <>
SparsePlane::Sparse(const Plane<std::uint8_t>& whole) : Sparse(whole.size()) {
    const Plane<std::uint8_t> occupied = fields::occupied_tiles(whole);
    tiles_.reserve(static_cast<std::size_t>(std::ranges::count(occupied.pixels(), std::uint8_t{1})));
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (occupied.pixels()[place] == 0) continue;
        held_[place] = static_cast<std::int32_t>(tiles_.size());
        const PixelBox box = box_of(place);
        auto into = tiles_.emplace_back().begin();
        for (int row = box.top; row < box.bottom; ++row, into += fields::tile_side) {
            std::ranges::copy_n(whole.row(row).begin() + box.left, box.width(), into);
        }
    }
}

template <class T>
PixelBox Sparse<T>::box_of(std::size_t place) const {
    const int left = static_cast<int>(place) % across_ * fields::tile_side;
    const int top = static_cast<int>(place) / across_ * fields::tile_side;
    return {left, top, std::min(left + fields::tile_side, size_.width),
            std::min(top + fields::tile_side, size_.height)};
}

template <class T>
void Sparse<T>::set(int i, int j, T value) {
    std::int32_t& held = held_[tile_index(i, j)];
    if (held == none) {
        if (value == T{}) return;
        held = static_cast<std::int32_t>(tiles_.size());
        tiles_.emplace_back();
    }
    tiles_[static_cast<std::size_t>(held)][within(i, j)] = value;
}

template <class T>
T Sparse<T>::greatest() const {
    T greatest = 0;
    for (const Tile& tile : tiles_) greatest = std::max(greatest, std::ranges::max(tile));
    return greatest;
}

template <class T>
std::int64_t Sparse<T>::count() const {
    std::int64_t count = 0;
    for (const Tile& tile : tiles_) count += std::ssize(tile) - std::ranges::count(tile, T{});
    return count;
}

template <class T>
std::int64_t count_union(const Sparse<T>& a, const Sparse<T>& b) {
    std::int64_t count = a.count() + b.count();
    for (std::size_t place = 0; place < a.held_.size(); ++place) {
        const auto* const in_a = a.tile_at(place);
        const auto* const in_b = b.tile_at(place);
        if (in_a == nullptr || in_b == nullptr) continue;
        for (std::size_t i = 0; i < in_a->size(); ++i) count -= ((*in_a)[i] != 0 && (*in_b)[i] != 0) ? 1 : 0;
    }
    return count;
}

template <class T>
PixelBox Sparse<T>::box() const {
    PixelBox box;
    for (std::size_t place = 0; place < held_.size(); ++place) {
        if (held_[place] != none) box = bounding_box(box, box_of(place));
    }
    return box;
}

template <class T>
void Sparse<T>::keep_maximum(const Sparse& other) {
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

template <class T>
bool operator==(const Sparse<T>& a, const Sparse<T>& b) {
    if (a.size_ != b.size_) return false;
    for (std::size_t place = 0; place < a.held_.size(); ++place) {
        const auto* const in_a = a.tile_at(place);
        const auto* const in_b = b.tile_at(place);
        if ((in_a == nullptr) != (in_b == nullptr) || (in_a != nullptr && *in_a != *in_b)) return false;
    }
    return true;
}

template class Sparse<std::uint8_t>;
template class Sparse<std::uint16_t>;
template std::int64_t count_union(const SparsePlane& a, const SparsePlane& b);
template bool operator==(const SparsePlane& a, const SparsePlane& b);
template bool operator==(const OwnerPlane& a, const OwnerPlane& b);

}  // namespace vvr::bricks
