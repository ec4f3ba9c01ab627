#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "core/pixel_box.h"

namespace vvr {

/// A frame of the clip and its time.
struct Moment {
    std::int64_t frame = 0;
    double seconds = 0;
};

/// A time for which something kept its place.
struct Stay {
    Moment first;
    Moment last;
    glm::dvec2 place{};  ///< its middle, field pixels; the centre of the first pixel is 0
    PixelBox box;
};

struct PathPoint {
    Moment at;
    glm::dvec2 place{};  ///< middle of what was seen, field pixels
};

/// Something that moved or was left: one connected object of the space-time volume.
struct Event {
    Moment first;
    Moment last;
    PixelBox box;                 ///< of all places where it was
    std::vector<PathPoint> path;  ///< coarse; its ends are those of the event
    double path_length = 0;       ///< field pixels, along the path
    std::vector<Stay> stays;
    std::optional<std::size_t> from;  ///< place in the list of the event out of which it came
    std::optional<std::size_t> into;  ///< of the event in which it went
};

/// What counts as an event. Seconds are those of the clip.
struct EventOptions {
    double stay = 2;     ///< what keeps its place for so long stood still
    double least = 0.8;  ///< what is seen for less is none
};

}  // namespace vvr
