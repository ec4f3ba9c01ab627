#pragma once

#include <cstdint>
#include <vector>

#include "core/plane.h"

namespace vvr {

/// The levels of a texture after its first, which is the picture: each of half the width and height of the one before
/// it, rounded down, and each pixel the mean of what it covers there; down to a single pixel.
std::vector<Plane<std::uint8_t>> mip_levels(const Plane<std::uint8_t>& picture);
std::vector<Plane<Bgr>> mip_levels(const Plane<Bgr>& picture);

}  // namespace vvr
