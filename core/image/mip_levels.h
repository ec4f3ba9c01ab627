#pragma once

#include <cstdint>
#include <vector>

#include "core/base/plane.h"

namespace vvr::image {

/// The levels of a texture below the picture itself, down to a single pixel. Each has half the width and height of the
/// level before, rounded down, and each of its pixels is the mean of those that it covers there.
std::vector<Plane<std::uint8_t>> mip_levels(const Plane<std::uint8_t>& picture);
std::vector<Plane<Bgr>> mip_levels(const Plane<Bgr>& picture);

}  // namespace vvr::image
