#pragma once

#include <cstdint>

#include "core/plane.h"

namespace vvr {

/// Sets to 0 every blob (pixels that are not 0 and touch, corners included) of fewer than `min_area` pixels.
void remove_small_blobs(Plane<std::uint8_t>& plane, int min_area);

}  // namespace vvr
