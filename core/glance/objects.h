#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/events/event.h"
#include "core/image/text.h"
#include "core/labels/time_ticks.h"

namespace vvr::glance {

/// The objects that a picture shows.
struct Objects {
    std::vector<events::Event> events;
    std::vector<std::size_t> numbers;  ///< by event: its index in the report's list, plus 1
    std::vector<glm::vec3> colours;    ///< by event, sRGB
    WallClock clock;

    image::Rgba colour_of(std::size_t event) const { return {colours[event], 1}; }
};

/// Indices of the events by importance to a reader: what was left or taken first, then the others, each the longest
/// first. A second of the longest stay counts four times.
std::vector<std::size_t> by_importance(std::span<const events::Event> events);

/// The event's longest stay; null if it has none.
const events::Stay* longest_stay(const events::Event& event);

/// The object's position on its path at a time of the clip in seconds, interpolated, in field pixels.
glm::dvec2 position_at(const events::Event& event, double seconds);

/// What the object did, as texts of decreasing length: "went ↗" (its direction in the frame), "stood 14 s", "left
/// behind". The table of event kinds has the words.
std::vector<std::string> activity_texts(const events::Event& event);

/// The times at which the object is shown as stationary: its stays, or its whole life if it was left or taken.
std::vector<events::Stay> stationary_times(const events::Event& event);

/// The event's time, as texts of decreasing length: "0:06–0:28", "0:06".
std::vector<std::string> time_texts(const events::Event& event, const WallClock& clock);

}  // namespace vvr::glance
