#pragma once

#include <string>

#include "core/image/compare.h"
#include "core/image/picture.h"

namespace vvr::image {

/// The differences of two pictures over the first of them in pale grey: from yellow for the smallest, through red, to
/// black for all of the range. Weak differences are amplified, so that all are visible.
/// \param comparison with numbers
Picture difference_picture(const Samples& a, const Comparison& comparison);

/// The same in letters for a terminal, at most `columns` wide, framed: the strongest difference of each cell, from
/// ` ` for at most `level`, by way of `.:-=+*#%`, to `@` for all of the range.
std::string difference_letters(const Plane<float>& pixels, double level, int columns = 60);

}  // namespace vvr::image
