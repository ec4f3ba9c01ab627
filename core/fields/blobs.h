#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/base/plane.h"

namespace vvr::fields {

/// Side of the square tiles in which occupancy and motion are tested, pixels.
inline constexpr int tile_side = 8;

/// 1 for each tile with a pixel other than 0. Eight pixels of a row are tested at a time.
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

// A blob is a connected component (8-connectivity) of pixels other than 0.

/// Hysteresis threshold: sets every blob to 0 that has fewer than `min_area` pixels, or fewer than `least` pixels whose
/// value reaches that of `strong` there.
void apply_hysteresis(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& strong, int least, int min_area);

/// Restores in `plane` the lost pixels of blobs of `before` that have at most `max_area` pixels, keep at least half of
/// them, and don't touch the picture's edge.
void restore_small_blobs(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& before, int max_area);

/// Which holes are filled. A hole is a connected component of zeros that a blob encloses; one at the picture's edge is
/// not enclosed.
struct HoleOptions {
    int max_area = 0;          ///< pixels; larger holes stay
    int least = 0;             ///< grey levels; holes with a smaller mean difference stay
    std::uint8_t value = 255;  ///< the value of filled pixels
};

/// \param differences grey levels, of the plane's size
void fill_holes(Plane<std::uint8_t>& plane, const Plane<std::uint8_t>& differences, const HoleOptions& options);

/// The steps from a filter's output to a scalar field.
struct CleanOptions {
    int threshold = 0;  ///< values below it become 0
    int gain = 1;       ///< then values are multiplied by it, 255 at most
    int min_area = 0;   ///< pixels; then smaller blobs become 0
};

/// \param region where it is 0, the plane becomes 0; empty = everywhere counts
void clean(Plane<std::uint8_t>& plane, const CleanOptions& options, const Plane<std::uint8_t>& region);

}  // namespace vvr::fields
