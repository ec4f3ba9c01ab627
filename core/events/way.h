#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace vvr::events {

/// Where an object was and when, in whole numbers: an archive keeps those of a hundred thousand events.
struct Waypoint {
    int time = 0;  ///< tenths of a second of the clip
    int x = 0;     ///< thousandths of the picture's width
    int y = 0;     ///< thousandths of its height

    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// \param place pixels of the clip; the centre of the first is 0. It counts as exactly as a report tells it, so that a
///        page, which knows more digits, has the same ways as an index, which is made of reports
/// \param size of the clip's picture
Waypoint waypoint(double seconds, const glm::dvec2& place, const glm::dvec2& size);

/// Thousandths of the picture by which a way may be off: less than a person's width in most scenes.
inline constexpr double waypoint_tolerance = 12;

/// As few of the points as keep every moment's place within `tolerance`, in the unit of the points.
std::vector<Waypoint> simplified(std::span<const Waypoint> way, double tolerance = waypoint_tolerance);

}  // namespace vvr::events
