#include "core/events/path.h"

namespace vvr {

namespace {

constexpr std::size_t most_points = 128;

}  // namespace

void Path::add(const Moment& now, const glm::dvec2& place) {
    last_ = {now, place};
    const std::size_t count = points_.size();
    if (count > 1 && points_[count - 1].place == place && points_[count - 2].place == place) points_.pop_back();
    if (!points_.empty() && now.seconds - points_.back().at.seconds < interval_) return;
    points_.push_back(last_);
    if (points_.size() < most_points) return;
    for (std::size_t k = 0; 2 * k < points_.size(); ++k) points_[k] = points_[2 * k];
    points_.resize((points_.size() + 1) / 2);
    interval_ *= 2;
}

std::vector<PathPoint> Path::points() const {
    std::vector<PathPoint> points = points_;
    if (!points.empty() && points.back().at.frame != last_.at.frame) points.push_back(last_);
    return points;
}

double length_of(const std::vector<PathPoint>& path) {
    double length = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += glm::distance(path[k - 1].place, path[k].place);
    return length;
}

}  // namespace vvr
