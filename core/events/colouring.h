#pragma once

#include <span>
#include <vector>

#include "core/events/event.h"

namespace vvr::events {

/// How many colours objects have: more can't be told apart by all eyes.
inline constexpr int object_colours = 8;

/// The colour of each event, 0 to `object_colours` - 1. Neighbours in space and time have different ones as long as
/// there are enough; where there are not, those that are farther from each other share one. The most telling events,
/// that last long and are large, choose first. The same events always get the same colours.
std::vector<int> colours_of(std::span<const Event> events);

}  // namespace vvr::events
