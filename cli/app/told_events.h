#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/events/event.h"

namespace vvr::app {

/// The events that a picture, a page and a report tell of.
struct ToldEvents {
    std::vector<events::Event> events;
    std::vector<std::size_t> numbers;  ///< by which people know them
    std::vector<int> colours;          ///< as `colours_of` gives them
};

/// Those of a clip that were there at some time from `begin` to `end`, with the part of their paths that lies in it.
/// Their numbers are their places among all, plus 1.
ToldEvents told_in(std::span<const events::Event> events, double begin, double end);

}  // namespace vvr::app
