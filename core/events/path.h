#pragma once

#include <vector>

#include "core/events/event.h"

namespace vvr {

/// The way of an object, in so few points that neither its limbs' swinging nor a day of it counts.
class Path {
  public:
    void add(const Moment& now, const glm::dvec2& place);

    /// The points so far, the last place among them.
    std::vector<PathPoint> points() const;

  private:
    std::vector<PathPoint> points_;
    PathPoint last_;
    double interval_ = 0.5;  ///< seconds; doubled whenever there are too many points
};

/// Along the points, in their unit.
double length_of(const std::vector<PathPoint>& path);

}  // namespace vvr
