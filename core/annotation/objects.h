#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "core/annotation/lettering.h"
#include "core/annotation/sheet.h"
#include "core/annotation/time_ticks.h"
#include "core/image/text.h"
#include "core/scene/flow_geometry.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/tracking/event.h"
#include "core/volume/volume.h"

namespace vvr::annotation {

/// The objects that a picture shows.
struct Objects {
    std::vector<tracking::Event> events;
    std::vector<std::size_t> numbers;  ///< by event: its index in the report's list, plus 1
    std::vector<glm::vec3> colours;    ///< by event, sRGB
    double end = 0;                    ///< time of the clip's last frame, seconds
    WallClock clock;

    image::Rgba colour_of(std::size_t event) const { return {colours[event], 1}; }
};

/// Indices of the events by importance to a reader: what was left or taken first, then the others, each the longest
/// first. A second of the longest stay counts four times. The slowest of the others, which this puts first, and the
/// largest come after at most three that were left or taken, so that they are always among the first.
std::vector<std::size_t> by_importance(std::span<const tracking::Event> events);

/// The event's longest stay; null if it has none.
const tracking::Stay* longest_stay(const tracking::Event& event);

/// The object's position on its path at a time of the clip in seconds, interpolated, in field pixels.
glm::dvec2 position_at(const tracking::Event& event, double seconds);

/// What the object did, as texts of decreasing length: "went up and right" (its direction in the frame), "stayed 14 s"
/// ("in all" if it is the sum of several stays), "left behind". The table of event kinds has the words. With what it
/// is, if that is known: "person · stayed 14 s".
std::vector<std::string> activity_texts(const tracking::Event& event);

/// The longest of these texts, without what it is: "went up and right".
std::string activity_text(const tracking::Event& event);

/// The times at which the object is shown as stationary: its stays, or its whole life if it was left or taken.
std::vector<tracking::Stay> stationary_times(const tracking::Event& event);

/// The event's time, as texts of decreasing length: "0:06–0:28", "0:06". Of a thing that was left behind, and was there
/// until the end of the clip: "0:06, still there", "from 0:06", "0:06"; until a gap: "0:06, still there at 0:28", ...
/// Of somebody who can't be told from another one from then on: "0:06–0:28, then with 2", "0:06–0:28 joins 2", ...
/// \param end time of the clip's last frame, seconds
/// \param into number of the other one; 0 = none
std::vector<std::string> time_texts(const tracking::Event& event, double end, const WallClock& clock,
                                    std::size_t into = 0);

/// Positions of a volume's objects in P-space and in a camera's picture. The arguments must outlive it.
class Trails {
  public:
    Trails(const volume::Volume& volume, const space::Layout& layout, const space::Camera& camera, Size picture)
        : volume_(volume), layout_(layout), camera_(camera), picture_(picture) {}

    /// Whether the volume has a time of the clip in seconds.
    bool has(double seconds) const;

    /// An object's position in P-space at a time of the clip in seconds.
    glm::dvec3 point(const tracking::Event& event, double seconds) const;

    /// As `point`, in pixels of the picture.
    glm::dvec2 pixel(const tracking::Event& event, double seconds) const {
        return camera_.pixel(point(event, seconds), picture_);
    }

  private:
    const volume::Volume& volume_;
    const space::Layout& layout_;
    const space::Camera& camera_;
    Size picture_;
};

/// Arrows along the objects' paths that show their directions, at equal intervals of time; none where an object is
/// stationary.
/// \param length of an arrow, P-space units
std::vector<scene::Glyph> direction_arrows(const Objects& objects, const volume::Volume& volume,
                                           const space::Layout& layout, double length);

/// Writes the numbers of objects at the start of their trails, the most important objects first, where there is room.
/// \param numbered indices of the events that get a number: those that the map or the time strip explains
void label_numbers(const Objects& objects, const std::set<std::size_t>& numbered, const Trails& trails,
                   const annotation::Sheet& sheet, annotation::Lettering& lettering);

/// Marks the known start and end of the longest stays: a tick across the trail, and the time if there is room.
void label_stays(const Objects& objects, const Trails& trails, const annotation::Sheet& sheet,
                 const image::Rgba& background, annotation::Lettering& lettering);

}  // namespace vvr::annotation
