#pragma once

#include <set>
#include <vector>

#include "core/events/event.h"

namespace vvr::events {

/// Which events are wanted.
struct EventChoice {
    std::set<EventKind> kinds{EventKind::moved, EventKind::stood, EventKind::left, EventKind::taken};
    double least = 0;  ///< seconds; shorter ones are left out
};

/// Those of the events that are wanted, in the same order. An event that named one of the others by its place names
/// nobody.
std::vector<Event> choose_events(std::vector<Event> events, const EventChoice& choice);

}  // namespace vvr::events
