#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/plane.h"

namespace vvr {

/// A size made smaller, in proportion, until its longer side is `side` at most.
inline Size fit_into(Size size, int side) {
    const double scale = std::min(1.0, static_cast<double>(side) / std::max(size.width, size.height));
    return {std::max(1, static_cast<int>(std::lround(size.width * scale))),
            std::max(1, static_cast<int>(std::lround(size.height * scale)))};
}

}  // namespace vvr
