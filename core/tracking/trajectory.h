#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/tracking/tracklet.h"

namespace vvr::tracking {

/// The cost of linking `later` to `earlier`, from the gap, the distance to the predicted place, and looks.
/// 1 or more means that they are different objects.
double link_cost(const Tracklet& earlier, const Tracklet& later);

/// Links tracklets by global data association: each gets at most one successor, so that the sum of costs is least (the
/// assignment form of Zhang, Li and Nevatia's min-cost flow, CVPR 2008).
/// \returns the index of each tracklet's successor
std::vector<std::optional<std::size_t>> link(std::span<const Tracklet> tracklets);

/// The whole trajectory of one object.
struct Trajectory {
    std::vector<std::size_t> tracks;  ///< numbers of its tracklets, by time
    Tracklet whole;                   ///< all tracklets joined
};

struct Trajectories {
    std::vector<Trajectory> all;
    std::map<std::size_t, std::size_t> of_track;  ///< from a track's number to an index in `all`
};

/// Links all tracklets of a clip to trajectories. Two objects that enter as one blob and split are two from the
/// beginning.
Trajectories join(std::vector<Tracklet> tracklets);

}  // namespace vvr::tracking
