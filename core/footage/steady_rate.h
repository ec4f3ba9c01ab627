#pragma once

#include <optional>
#include <vector>

#include "core/footage/segment.h"

namespace vvr::footage {

/// How the files of a camera that sends fewer frames per second than they state fill their time.
struct SteadyRate {
    double rate = 0;    ///< frames per second at which each file lasts until the next begins
    double stated = 0;  ///< frames per second by the files
    double length = 0;  ///< of a file, as stated, seconds
    double pace = 0;    ///< from the begin of a file to that of the next one, seconds
};

/// Finds out whether a camera sends fewer frames per second than its recorder states: then each file ends before the
/// next begins, all in the same ratio.
/// \param segments in order
std::optional<SteadyRate> find_steady_rate(const std::vector<Segment>& segments);

}  // namespace vvr::footage
