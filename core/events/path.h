#pragma once

#include <vector>

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

}  // namespace vvr::events
