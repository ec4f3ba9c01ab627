#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/events/event.h"
#include "core/labels/time_ticks.h"

namespace vvr::glance {

/// The objects of a clip as a picture shows them.
struct Objects {
    std::vector<events::Event> events;
    std::vector<std::size_t> numbers;  ///< of each event: its place in the report's list, plus 1
    std::vector<glm::vec3> colours;    ///< of each event, sRGB
    WallClock clock;
};

/// The places of the events in the order in which a reader wants to know of them: first what was left or taken, then
/// the others; of each the longest first, where a second for which something stood counts four times.
std::vector<std::size_t> by_importance(std::span<const events::Event> events);

/// The longest of its stays; nothing where it has none.
const events::Stay* longest_stay(const events::Event& event);

/// Where it was at a time: field pixels, on its path.
glm::dvec2 place_at(const events::Event& event, double seconds);

/// What it did, in a word or three, and shorter where there is little room: "went ↗", with its way in the frame,
/// "stood 14 s", "left behind"; the table of kinds has the words.
std::vector<std::string> activity_texts(const events::Event& event);

/// The times for which a picture shows that it stood or lay: its stays; of what lies there, all of its time.
std::vector<events::Stay> standing_times(const events::Event& event);

/// When: "0:06–0:28", and shorter: "0:06".
std::vector<std::string> times_of(const events::Event& event, const WallClock& clock);

}  // namespace vvr::glance
