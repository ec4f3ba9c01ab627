#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/tracking/event.h"

namespace vvr::tracking {

/// The path of an object, sampled so coarsely that swinging limbs don't count and that a day needs few points.
class Path {
  public:
    /// \param area of the visible part, field pixels
    void add(const Moment& now, const glm::dvec2& place, int area = 0);

    /// The points so far, including the last place.
    std::vector<PathPoint> points() const;

    /// The area at each of the points.
    std::vector<int> areas() const;

  private:
    struct Point {
        PathPoint point;
        int area = 0;
    };

    std::vector<Point> all() const;

    std::vector<Point> points_;
    Point last_;
    double interval_ = 0.5;  ///< seconds; doubled whenever there are too many points
};

/// The length along the points, in their unit.
double length_of(const std::vector<PathPoint>& path);

/// The mean cosine between consecutive steps, weighted by their lengths: 1 on a straight path, 0 or less where it jumps
/// about. 1 for fewer than four points.
double straightness_of(const std::vector<PathPoint>& path);

/// Where an object went in the frame.
struct Heading {
    std::string_view name;
    std::string_view arrow;
    std::string_view words;
};

/// Eighths of a turn, clockwise from the right.
inline constexpr std::array headings{Heading{"right", "→", "to the right"},
                                     Heading{"down-right", "↘", "down and right"},
                                     Heading{"down", "↓", "down"},
                                     Heading{"down-left", "↙", "down and left"},
                                     Heading{"left", "←", "to the left"},
                                     Heading{"up-left", "↖", "up and left"},
                                     Heading{"up", "↑", "up"},
                                     Heading{"up-right", "↗", "up and right"}};

/// The object ended near where it began, after a long way.
inline constexpr Heading to_and_fro{"to and fro", "⇄", "to and fro"};

/// The direction from the first to the last place. `to_and_fro` if they are near each other, both compared with the
/// length of the path and with the area that it covers.
/// \param path not empty
const Heading& heading_of(std::span<const PathPoint> path, double length);

/// The heading of that name; null if there is none.
const Heading* find_heading(std::string_view name);

/// The place at a frame, interpolated linearly.
glm::dvec2 place_at(const std::vector<PathPoint>& path, std::int64_t frame);

/// The path with every second point dropped until it has at most 128.
std::vector<PathPoint> thinned(std::vector<PathPoint> path);

/// Finds the times in which an object, such as a waiting person, kept its place but was not quite still.
class Stays {
  public:
    /// minimum seconds of a stay
    explicit Stays(double least) : least_(least) {}

    /// \param reach largest distance of the centre from the first place, field pixels
    void add(const Moment& now, const glm::dvec2& place, const PixelBox& box, double reach);

    /// Adds a stay that is known exactly. It replaces all that were found from its first frame on.
    void add_exactly(const Stay& stay);

    /// The current stay, of any duration.
    const std::optional<Stay>& open() const { return open_; }

    /// Ends the current stay.
    /// \returns all stays, in order
    std::vector<Stay> finish();

  private:
    void close();

    double least_;
    std::optional<Stay> open_;
    int sightings_ = 0;  ///< of the open stay
    std::vector<Stay> found_;
};

/// A point of a path in whole numbers, because an archive keeps the paths of a hundred thousand events.
struct Waypoint {
    int time = 0;  ///< tenths of a second of the clip
    int x = 0;     ///< thousandths of the picture's width
    int y = 0;     ///< thousandths of its height

    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// \param place pixels of the clip; the centre of the first pixel is 0. It is rounded to the digits of a report, so
///        that a page and an index (which is made of reports) have the same waypoints.
/// \param size of the clip's picture, pixels
Waypoint waypoint(double seconds, const glm::dvec2& place, const glm::dvec2& size);

/// Largest error of a simplified path, thousandths of the picture: less than a person's width in most scenes.
inline constexpr double waypoint_tolerance = 12;

/// Simplifies a path (Douglas-Peucker with synchronized distance).
/// \param tolerance largest error of the place at any moment, in the unit of the points
std::vector<Waypoint> simplified(std::span<const Waypoint> way, double tolerance = waypoint_tolerance);

}  // namespace vvr::tracking
