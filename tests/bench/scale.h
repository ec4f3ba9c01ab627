#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/plane.h"

namespace vvr::bench {

/// A part of a benchmark's work, for trying quickly whether all of it works: of a count, or of each side of a picture.
inline int scaled(int count, double scale) {
    return std::max(1, static_cast<int>(std::lround(scale * count)));
}

inline Size scaled(Size size, double scale) {
    return {scaled(size.width, scale), scaled(size.height, scale)};
}

}  // namespace vvr::bench
