#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/tracking/appearance.h"
#include "core/tracking/event.h"
#include "core/tracking/event_options.h"

namespace vvr::tracking {

/// What is known of an object when it becomes stationary.
struct Settled {
    Patch patch;                  ///< its steady pixels
    Moment since;                 ///< when its pixels became steady
    Evidence evidence;            ///< all terms but `carried`, `novelty` and `confidence`
    std::optional<Patch> region;  ///< the pixels of the field in which its stay differs from the empty scene
    bool found_standing = false;  ///< it was never seen to move: nobody saw it come
};

/// One end of a tracklet.
struct TrackEnd {
    Moment at;
    glm::dvec2 place{};
    glm::dvec2 velocity{};   ///< field pixels per second
    bool at_border = false;  ///< it touched the border of the field, and entered or left there
};

/// A track that has ended: an object, or a part of its path.
struct Tracklet {
    std::size_t number = 0;
    std::optional<std::size_t> from;  ///< number of the track from which it split
    std::optional<std::size_t> into;  ///< number of the track in which it merged
    TrackEnd begin;
    TrackEnd end;
    double length = 0;          ///< longer side of the object, field pixels
    glm::dvec2 size{};          ///< width and height, field pixels
    double area = 0;            ///< of the object when alone, field pixels
    double area_of_parent = 0;  ///< of `from` before the split if that was alone, else 0; field pixels
    double seen = 0;            ///< share of its frames in which it was seen
    double continuous = 1;      ///< share of its detections without a jump
    /// Hellinger distance between the looks of its box in the frames and in the empty scene. A person brings colours of
    /// its own. A door, balloons or leaves only move those that are there.
    double novelty = 1;
    double moved = 0;  ///< diagonal of the box around all its places, field pixels
    PixelBox box;      ///< around all its places
    Appearance appearance;
    std::vector<PathPoint> path;
    std::vector<int> areas;  ///< field pixels, one per point of the path
    std::vector<Stay> stays;
    std::optional<Settled> settled;  ///< its last stationary state
    bool stood_from_start = false;   ///< nobody saw it come, and it has not moved since
    bool stood_to_end = false;       ///< it was stationary when last seen
    Moment gone;                     ///< when its absence became certain
    std::optional<Portrait> portrait;
    std::size_t stretch = 0;  ///< index of the stretch between two gaps; nothing links stretches
    bool in_scene = false;    ///< the empty scene shows it: the fields show its ghost while it is absent

    double seconds() const { return end.at.seconds - begin.at.seconds; }

    /// Whether it has been seen for so long that it is no fragment or noise.
    bool is_confirmed() const { return seconds() >= thresholds.event.least; }
};

}  // namespace vvr::tracking
