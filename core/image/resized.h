#pragma once

#include "core/base/plane.h"

namespace vvr::image {

/// A plane of bytes, of BGR or of RGBA floats at another size. Where it shrinks, each pixel is the mean of those that
/// it covers; where it grows, values are interpolated.
template <class T>
Plane<T> resized(const Plane<T>& plane, Size size);

}  // namespace vvr::image
