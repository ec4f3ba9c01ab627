#pragma once

#include <span>
#include <vector>

#include "core/events/event.h"

namespace vvr::events {

/// Number of colours for objects. Not everybody can tell more apart.
inline constexpr int object_colours = 8;

/// The colour of each event, from 0 to `object_colours` - 1 (greedy graph colouring). Neighbours in space and time get
/// different colours while there are enough; else the events that are farthest apart share one. Long and large events
/// choose first. The result is deterministic.
std::vector<int> colours_of(std::span<const Event> events);

}  // namespace vvr::events
