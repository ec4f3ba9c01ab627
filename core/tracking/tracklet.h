#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "core/tracking/appearance.h"
#include "core/tracking/difference.h"
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
    Difference difference;      ///< mean over its sightings
    int differences = 0;        ///< values in the mean
    double moved = 0;           ///< diagonal of the box around all its places, field pixels
    PixelBox box;               ///< around all its places
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

/// The cost of linking `later` to `earlier`, from the gap, the distance to the predicted place, and looks.
/// 1 or more means that they are different objects.
double link_cost(const Tracklet& earlier, const Tracklet& later);

/// Links tracklets by global data association: each gets at most one successor, so that the sum of costs is least (the
/// assignment form of Zhang, Li and Nevatia's min-cost flow, CVPR 2008).
/// \returns the index of each tracklet's successor
std::vector<std::optional<std::size_t>> link(std::span<const Tracklet> tracklets);

/// The whole trajectory of one object.
struct Trajectory {
    std::vector<std::size_t> tracks;  ///< numbers of its tracklets, by time
    Tracklet whole;                   ///< all tracklets joined
};

struct Trajectories {
    std::vector<Trajectory> all;
    std::map<std::size_t, std::size_t> of_track;  ///< from a track's number to an index in `all`
};

/// Links all tracklets of a clip to trajectories. Two objects that enter as one blob and split are two from the
/// beginning.
Trajectories join(std::vector<Tracklet> tracklets);

// Where objects were at a moment, and which of them were near each other.

/// The object's box at a moment; nothing where it was not seen then.
std::optional<PixelBox> box_at(const Tracklet& object, double seconds, std::int64_t frame);

/// Whether `piece` is a fragment of `whole`: inside its box for most of its own time.
bool is_fragment_of(const Tracklet& piece, const Tracklet& whole);

/// Whether an object with this box is within its own width, and half its height, of a place. False without a box.
bool is_near(const std::optional<PixelBox>& box, const PixelBox& place);

/// Whether the bearer was beside the thing's place just before or after it appeared.
bool was_beside(const Tracklet& bearer, const Tracklet& thing, double seconds_per_frame);

/// Whether an object can have brought or taken a thing: whoever takes a thing comes from elsewhere, and whoever
/// leaves one goes elsewhere. Somebody who stood there only uncovers the place, and somebody who ends there is the
/// thing.
bool can_carry(const Tracklet& bearer, const Tracklet& thing, EventKind kind, Size field);

/// The moment from which a thing was alone: when its owner last went a length away from it, or had gone.
std::optional<Moment> alone_since(const Event& thing, const Event& owner, double length);

}  // namespace vvr::tracking
