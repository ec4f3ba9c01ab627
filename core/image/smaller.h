#pragma once

#include "core/image/picture.h"

namespace vvr {

/// The picture, without its layers, with no side longer than `side`: each pixel the mean of those that it stands for.
Picture smaller(const Picture& picture, int side);

}  // namespace vvr
