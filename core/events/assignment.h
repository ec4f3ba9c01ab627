#pragma once

#include <optional>
#include <vector>

#include "core/base/plane.h"

namespace vvr::events {

/// Gives each row at most one column, so that the sum of the costs is the least that there is (the Hungarian method
/// with potentials, after Kuhn and Munkres: O(rows² · columns)).
/// \param costs a row's cost for each column; `most` or more means never
/// \returns the column of each row
std::vector<std::optional<int>> assign(const Plane<double>& costs, double most);

}  // namespace vvr::events
