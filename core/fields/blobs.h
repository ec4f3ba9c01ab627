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

// A blob is a set of pixels that are not 0 and touch, corners included.

/// Sets to 0 every blob of fewer than `min_area` pixels.
void remove_small_blobs(Plane<std::uint8_t>& plane, int min_area);

/// Sets to 0 every blob of fewer than `min_area` pixels, or in which fewer than `least` of them reach the value that
/// `strong` has there.
void apply_hysteresis(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& strong, int least, int min_area);

/// Gives back to `plane` what it has lost of each blob of `before` that has at most `max_area` pixels, of which at
/// least half are left and that lies within the picture.
void restore_small_blobs(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& before, int max_area);

/// Which holes are filled: what is 0 and enclosed by a blob. What touches the picture's edge is not enclosed.
struct HoleOptions {
    int max_area = 0;          ///< pixels; larger ones stay
    int least = 0;             ///< grey levels; those whose mean difference is less stay
    std::uint8_t value = 255;  ///< that they get
};

/// \param differences grey levels, of the plane's size
void fill_holes(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& differences, const HoleOptions& options);

/// How what a filter found becomes a scalar field.
struct CleanOptions {
    int threshold = 0;  ///< values below it become 0
    int gain = 1;       ///< then all are multiplied by it, 255 at most
    int min_area = 0;   ///< pixels; then blobs of fewer become 0
};

/// \param region where it is 0, so becomes the plane; empty for everywhere
void clean(Plane<std::uint8_t>& plane, const CleanOptions& options, const Plane<std::uint8_t>& region);

}  // namespace vvr::fields
