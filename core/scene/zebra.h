#pragma once

#include <cstdint>

#include "core/base/plane.h"

namespace vvr::scene {

/// One period of the texture that moves along tracelines (§6.2.1), from dark (0) to bright (255): a dark stripe and
/// a bright one of the same length with soft borders. A single row.
Plane<std::uint8_t> zebra_texels();

}  // namespace vvr::scene
