#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/events/event_options.h"
#include "core/events/tracklet.h"

namespace vvr::events {

/// What it costs to take `later` for the same object as `earlier`: by the gap, by how far it is from where motion led,
/// and by looks. `EventOptions::link_cost` or more means that it is another.
double link_cost(const Tracklet& earlier, const Tracklet& later, const EventOptions& options);

/// Joins tracklets to objects: each is followed by at most one, the cheapest for all of them together (the assignment
/// form of Zhang, Li and Nevatia's min-cost flow, 2008).
/// \returns for each tracklet the place of the one that follows it
std::vector<std::optional<std::size_t>> link(std::span<const Tracklet> tracklets, const EventOptions& options);

}  // namespace vvr::events
