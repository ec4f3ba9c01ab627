#pragma once

#include <vector>

#include "core/bricks/layer.h"
#include "core/bricks/volume.h"

namespace vvr::glance {

/// An interval of the clip, in seconds.
struct Period {
    double begin = 0;
    double end = 0;
};

/// The rest of the clip, in order.
/// \param busy periods in any order; they may overlap
std::vector<Period> idle_periods(std::vector<Period> busy, double begin, double end);

/// The times at which something compact differs from the empty scene and belongs to no object, for as long as an event
/// lasts at least. Somebody may be there.
std::vector<Period> unexplained_periods(const bricks::Volume& volume, const bricks::Identify& identify);

}  // namespace vvr::glance
