#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/events/tracklet.h"

namespace vvr::events {

/// What it costs to take `later` for the same object as `earlier`: by the gap, by how far it is from where motion led,
/// and by looks. `thresholds.link.cost` or more means that it is another.
double link_cost(const Tracklet& earlier, const Tracklet& later);

/// Links tracklets to objects: each is followed by at most one, the cheapest for all of them together (the assignment
/// form of Zhang, Li and Nevatia's min-cost flow, 2008).
/// \returns for each tracklet the place of the one that follows it
std::vector<std::optional<std::size_t>> link(std::span<const Tracklet> tracklets);

/// The whole way of one object.
struct Trajectory {
    std::vector<std::size_t> tracks;  ///< numbers of its tracklets, in order of time
    Tracklet whole;                   ///< all of them as one
};

struct Trajectories {
    std::vector<Trajectory> all;
    std::map<std::size_t, std::size_t> of_track;  ///< from the number of a track to a place in `all`
};

/// Links all tracklets of a clip. Two who come as one blob and part are two from the beginning.
Trajectories join(std::vector<Tracklet> tracklets);

}  // namespace vvr::events
