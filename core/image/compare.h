#pragma once

#include "core/image/picture.h"

namespace vvr {

/// How far two pictures are apart. A value that is not a number in either of them is infinitely far off.
struct Difference {
    Plane<float> pixels;  ///< the largest difference of a pixel's four values
    double max = 0;
    double mean = 0;  ///< of the pixels' differences
    int worst_column = 0;
    int worst_row = 0;
};

/// Compares pixel by pixel, as the values stand.
/// \throws Error differs when the sizes do
Difference compare(const Picture& a, const Picture& b);

/// The difference that the given part of all pixels, 0..1, does not exceed: 0.999 for the 99.9th percentile.
float percentile(const Difference& difference, double part);

}  // namespace vvr
