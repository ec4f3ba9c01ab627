#pragma once

#include <span>
#include <vector>

#include "core/tracking/event.h"

namespace vvr::tracking {

/// Number of colours for objects. Not everybody can tell more apart.
inline constexpr int object_colours = 8;

/// The colour of each event, from 0 to `object_colours` - 1. Events choose in the order of their first frames, so two
/// that are there at once share a colour only if all colours are in use (greedy colouring of an interval graph). Each
/// event also avoids the colours of the four before it, then those of events near it in space and time, then those that
/// were used last. The result is deterministic.
std::vector<int> colours_of(std::span<const Event> events);

}  // namespace vvr::tracking
