#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/detector/classes.h"
#include "core/tracking/event_kind.h"
#include "core/tracking/signs.h"

namespace vvr::tracking {

/// A time in which an object kept its place.
struct Stay {
    Moment first;
    Moment last;
    glm::dvec2 place{};  ///< its centre, field pixels; the centre of the first pixel is 0
    PixelBox box;
};

struct PathPoint {
    Moment at;
    glm::dvec2 place{};  ///< centre of the visible part, field pixels
};

/// The frame that shows an object best: large, sharp, whole and alone.
struct Portrait {
    Moment at;
    PixelBox box;      ///< field pixels
    double score = 0;  ///< larger is better; comparable within one clip only
};

/// What the empty scene shows of an object. If the scene was made of frames with a bag in it, the fields show a ghost
/// before the bag came and nothing while it was there.
struct ScenePatch {
    PixelBox box;                ///< field pixels
    Plane<std::uint8_t> values;  ///< of the ghost, in the box; 0 = not of the object
};

/// Why something is said to have been left or taken. Each term is independent of the others.
struct Evidence {
    double difference = 0;               ///< mean of the stay against the empty scene, grey levels
    double edges = 0;                    ///< contrast across its outline in the mean of the stay, grey levels
    double scene_edges = 0;              ///< the same in the empty scene: a thing has an outline in one of them only
    double thickness = 0;                ///< 1 = a disk; a thing that was only shifted differs in thin slivers
    double alone = 0;                    ///< seconds in which it was in view with nobody near
    double moved = 0;                    ///< lengths that it moved by itself before it became still; a thing doesn't
    double novelty = 0;                  ///< how its box differs in looks from the scene's; a door only moves looks
    double flicker = 0;                  ///< changes per pixel: leaves and digits change all the time
    double changed = 0;                  ///< share of the picture that differed when it appeared: a train, a lamp
    bool carried = false;                ///< somebody or something was there to bring or take it
    double confidence = 0;               ///< 0 to 1
    std::optional<EventKind> refuted{};  ///< the claim that was made, before a detector showed that it is no thing
};

/// What an object is, as a detector tells from pictures of it.
struct Identity {
    const detector::ObjectClass* what = nullptr;  ///< never null
    double score = 0;                             ///< of the best picture, 0 to 1
    int looks = 0;                                ///< number of pictures that agree on the group
};

/// Something that differs from the empty scene for a while, without enough evidence to say what it is.
struct Change {
    Moment first;
    Moment last;
    PixelBox box;  ///< field pixels
    Evidence evidence;
    Signs signs{};
};

/// One object in the space-time volume, from its first to its last frame.
struct Event {
    EventKind kind = EventKind::moved;
    Moment first;
    Moment last;
    PixelBox box;                 ///< of all its places
    std::vector<PathPoint> path;  ///< coarse; it begins and ends with the event
    double path_length = 0;       ///< along the path, field pixels
    std::vector<Stay> stays;
    std::optional<std::size_t> from;    ///< index of the event from which it split
    std::optional<std::size_t> into;    ///< index of the event in which it merged
    std::optional<std::size_t> by;      ///< index of the event that put it down or took it
    std::optional<Moment> alone_since;  ///< for a thing left behind: when whoever left it had gone
    std::optional<Portrait> portrait;
    std::optional<ScenePatch> in_scene;  ///< none if the fields show it while it was there
    std::optional<Evidence> evidence;    ///< for what was left or taken
    Signs signs{};                       ///< what speaks for it
    std::optional<Identity> identity;    ///< none without a detector, or if it knows no such object
    bool open_ended = false;             ///< it lasted until a gap or the end of the clip: what came then is unknown
    std::size_t view = 0;                ///< of the camera, as `fields::Field::view`
    std::vector<std::size_t> tracks;     ///< the labels of its pixels in `FrameLabels`
};

/// All that is found in a clip.
struct Findings {
    std::vector<Event> events;       ///< by their first frames
    std::vector<Change> changes;     ///< by their first frames
    std::vector<PixelBox> overlays;  ///< clocks that the camera writes into its pictures, field pixels
    std::vector<Moment> begins;      ///< of the stretches without a gap
    double largest_share = 0;        ///< largest share of the picture that differs from the empty scene in a frame
};

/// The sum of its stays, seconds.
double stationary_seconds(const Event& event);

/// When objects move, seconds from and to, one interval after another per event. A thing that lies there doesn't, nor
/// does whoever stands longer than a minute.
std::vector<std::pair<double, double>> busy_times(std::span<const Event> events);

/// A filter of events.
struct EventChoice {
    std::set<EventKind> kinds = all_kinds();
    double least = 0;  ///< seconds; shorter events are dropped

    bool accepts(const Event& event) const {
        return kinds.contains(event.kind) && event.last.seconds - event.first.seconds >= least;
    }
};

/// The chosen events, in the same order. References to other events are renumbered, and removed where the other was not
/// chosen.
std::vector<Event> choose_events(std::vector<Event> events, const EventChoice& choice);

/// Small events that crowd one part of the picture: a screen, a flag, a far road, fragments of a stationary object.
struct Clutter {
    std::int64_t count = 0;  ///< of all small events
    PixelBox box;            ///< of the small events in that part, field pixels
    Moment at;               ///< when one of them is visible
};

/// Finds clutter. An event is small if its box is at most an eighth of the picture's longer side, both ways. Small
/// events are clutter if there are at least a dozen, they are at least half of all events, and at least half of them
/// lie in one ninth of the picture (a third of its width and height).
/// \returns nothing where they are not
std::optional<Clutter> find_clutter(std::span<const Event> events, Size field);

}  // namespace vvr::tracking
