#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/events/event.h"

namespace vvr::events {

/// The way of an object, in so few points that neither its limbs' swinging nor a day of it counts.
class Path {
  public:
    /// \param area of what was seen, pixels
    void add(const Moment& now, const glm::dvec2& place, int area = 0);

    /// The points so far, the last place among them.
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

/// Along the points, in their unit.
double length_of(const std::vector<PathPoint>& path);

/// How well each step goes on in the direction of the one before: 1 on a straight way, 0 or less where it jumps about.
/// 1 for a path of fewer than four points.
double straightness_of(const std::vector<PathPoint>& path);

/// Where it is at that frame, between the points.
glm::dvec2 place_at(const std::vector<PathPoint>& path, std::int64_t frame);

/// Every other point, as often as it takes to be no more than a path may have.
std::vector<PathPoint> thinned(std::vector<PathPoint> path);

/// Finds the times for which something that need not be quite still, as a person who waits, kept its place.
class Stays {
  public:
    /// \param least seconds that make a stay
    explicit Stays(double least) : least_(least) {}

    /// \param reach field pixels by which the middle may be off its first place
    void add(const Moment& now, const glm::dvec2& place, const PixelBox& box, double reach);

    /// Takes the place of what was found for that time.
    void add_exactly(const Stay& stay);

    /// What has not come to its end.
    const std::optional<Stay>& open() const { return open_; }

    /// All of them, in order.
    std::vector<Stay> finish();

  private:
    void close();

    double least_;
    std::optional<Stay> open_;
    std::vector<Stay> found_;
};

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
