#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/events/event_kind.h"

namespace vvr::events {

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

/// The frame in which an object is seen best: large, sharp, whole and alone.
struct Portrait {
    Moment at;
    PixelBox box;      ///< field pixels
    double score = 0;  ///< larger is better; of use between portraits of one clip
};

/// What the empty scene that the fields were compared with holds of an object: where the scene was made of frames with
/// a bag in it, the fields show a ghost before the bag came, and nothing while it was there.
struct ScenePatch {
    PixelBox box;                ///< field pixels
    Plane<std::uint8_t> values;  ///< of the ghost, in the box; 0 = not of the object
};

/// One object of the space-time volume, from its first to its last frame.
struct Event {
    EventKind kind = EventKind::moved;
    Moment first;
    Moment last;
    PixelBox box;                 ///< of all places where it was
    std::vector<PathPoint> path;  ///< coarse; its ends are those of the event
    double path_length = 0;       ///< field pixels, along the path
    std::vector<Stay> stays;
    std::optional<std::size_t> from;    ///< place in the list of the event out of which it came
    std::optional<std::size_t> into;    ///< of the event in which it went
    std::optional<std::size_t> by;      ///< of the event that put it down, or took it
    std::optional<Moment> alone_since;  ///< of what was left: when whoever left it had gone
    std::optional<Portrait> portrait;
    std::optional<ScenePatch> in_scene;  ///< none where the fields show it while it was there
    std::vector<std::size_t> tracks;     ///< the numbers that its pixels have in `FrameLabels`
};

/// Seconds for which it kept its place.
double stationary_seconds(const Event& event);

/// Which events are wanted.
struct EventChoice {
    std::set<EventKind> kinds = all_kinds();
    double least = 0;  ///< seconds; shorter ones are left out
};

/// Those of the events that are wanted, in the same order. An event that named one of the others by its place names
/// nobody.
std::vector<Event> choose_events(std::vector<Event> events, const EventChoice& choice);

/// Small events that crowd one part of the picture: a screen, a flag, a far road, pieces of what stands there.
struct Clutter {
    std::int64_t count = 0;  ///< of all scraps
    PixelBox box;            ///< of those in the part, field pixels
    Moment at;               ///< when one of them is seen
};

/// A scrap is an event that never leaves an eighth of the picture's long side, both ways. Scraps dominate where there
/// are a dozen or more, they are half of all events or more, and half of them or more lie in one ninth of the picture,
/// a third of its width and height.
/// \returns nothing where they do not
std::optional<Clutter> find_clutter(std::span<const Event> events, Size field);

}  // namespace vvr::events
