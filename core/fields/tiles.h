#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/plane.h"

namespace vvr::fields {

/// Side of the squares in which it is looked where something is, and where it moves.
inline constexpr int tile_side = 8;

/// 1 for each tile in which something isn't 0. Eight pixels of a row are looked at at a time.
inline Plane<std::uint8_t> occupied_tiles(const Plane<std::uint8_t>& plane) {
    static_assert(tile_side == sizeof(std::uint64_t));
    const Size size{(plane.width() + tile_side - 1) / tile_side, (plane.height() + tile_side - 1) / tile_side};
    Plane<std::uint8_t> result(size);
    for (int j = 0; j < plane.height(); ++j) {
        const std::uint8_t* const row = plane.row(j).data();
        std::uint8_t* const out = result.row(j / tile_side).data();
        for (int x = 0; x < size.width; ++x) {
            std::uint64_t eight = 0;
            std::memcpy(&eight, row + x * tile_side,
                        static_cast<std::size_t>(std::min(tile_side, plane.width() - x * tile_side)));
            out[x] = static_cast<std::uint8_t>(out[x] | (eight != 0 ? 1 : 0));
        }
    }
    return result;
}

}  // namespace vvr::fields
