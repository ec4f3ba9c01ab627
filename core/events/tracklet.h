#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/events/appearance.h"
#include "core/events/event.h"

namespace vvr::events {

/// What is known of an object when it settled.
struct Settled {
    Patch patch;       ///< as it stands
    Moment since;      ///< when its pixels became steady
    double edges = 0;  ///< of the frame along its outline, grey levels
};

/// One end of a tracklet.
struct TrackEnd {
    Moment at;
    glm::dvec2 place{};
    glm::dvec2 velocity{};   ///< field pixels per second
    bool at_border = false;  ///< it touched the border of the field: it came in or went out there
};

/// A track that has come to its end: an object, or a part of its way.
struct Tracklet {
    std::size_t number = 0;
    std::optional<std::size_t> from;  ///< number of the track out of which it came
    std::optional<std::size_t> into;  ///< of the track in which it went
    TrackEnd begin;
    TrackEnd end;
    double length = 0;          ///< of the object, its longer side, field pixels
    glm::dvec2 size{};          ///< width and height
    double area = 0;            ///< of the object when it was alone, pixels
    double area_of_parent = 0;  ///< of `from` before they came apart, where that was alone; else 0
    double seen = 0;            ///< share of the frames of its life in which it was seen
    double continuous = 1;      ///< share of its sightings in which it was where motion led, and had not jumped
    double moved = 0;           ///< the diagonal of the box about all its places
    double flicker = 0;         ///< how often its pixels came and went, the mean over its life
    PixelBox box;               ///< of all its places
    Appearance look;
    std::vector<PathPoint> path;
    std::vector<int> areas;  ///< at the points of the path
    std::vector<Stay> stays;
    std::optional<Settled> settled;  ///< where it has stood, the last time
    bool stood_from_start = false;   ///< it was seen standing only: nobody saw it come
    bool stood_to_end = false;       ///< it stood when it was last seen
    Moment gone;                     ///< when it was certain that it is not there any more
    std::optional<Portrait> portrait;
    std::size_t stretch = 0;  ///< between two gaps, in which it was: it tells nothing of another
    bool in_scene = false;    ///< the empty scene holds it: the fields showed its ghost, as long as it was not there

    double seconds() const { return end.at.seconds - begin.at.seconds; }
};

}  // namespace vvr::events
