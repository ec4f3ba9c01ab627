#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/moment.h"
#include "core/base/pixel_box.h"
#include "core/base/plane.h"

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

enum class EventKind {
    moved,  ///< it went through the scene
    stood,  ///< it went, and kept its place for a while
    left,   ///< somebody put it down
    taken,  ///< it belonged to the empty scene, and went
};

/// One row of the table of kinds.
struct EventKindRow {
    EventKind kind;
    std::string_view name;
    std::string_view help;
};

/// The kinds, in the order of EventKind.
std::span<const EventKindRow> event_kinds();

/// "moved", "stood", "left" or "taken".
std::string_view name_of(EventKind kind);

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

}  // namespace vvr::events
