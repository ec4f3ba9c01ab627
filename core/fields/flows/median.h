#pragma once

#include "core/plane.h"

namespace vvr {

/// The median of each value and its eight neighbours; edges repeat. Between the steps of a coarse-to-fine flow it
/// throws out single wrong vectors and keeps the borders of what moves (Sun, Roth and Black, CVPR 2010).
Plane<float> median_of_nine(const Plane<float>& plane);

}  // namespace vvr
