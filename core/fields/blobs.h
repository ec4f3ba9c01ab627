#pragma once

#include <cstdint>

#include "core/base/plane.h"

namespace vvr::fields {

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

}  // namespace vvr::fields
