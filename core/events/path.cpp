#include "core/events/path.h"

#include <algorithm>

namespace vvr::events {

namespace {

constexpr std::size_t most_points = 128;

template <class Point>
void halve(std::vector<Point>& points) {
    for (std::size_t k = 0; 2 * k < points.size(); ++k) points[k] = points[2 * k];
    points.resize((points.size() + 1) / 2);
}

}  // namespace

void Path::add(const Moment& now, const glm::dvec2& place, int area) {
    last_ = {{now, place}, area};
    const std::size_t count = points_.size();
    if (count > 1 && points_[count - 1].point.place == place && points_[count - 2].point.place == place) {
        points_.pop_back();
    }
    if (!points_.empty() && now.seconds - points_.back().point.at.seconds < interval_) return;
    points_.push_back(last_);
    if (points_.size() < most_points) return;
    halve(points_);
    interval_ *= 2;
}

std::vector<Path::Point> Path::all() const {
    std::vector<Point> points = points_;
    if (!points.empty() && points.back().point.at.frame != last_.point.at.frame) points.push_back(last_);
    return points;
}

std::vector<PathPoint> Path::points() const {
    std::vector<PathPoint> points;
    for (const Point& point : all()) points.push_back(point.point);
    return points;
}

std::vector<int> Path::areas() const {
    std::vector<int> areas;
    for (const Point& point : all()) areas.push_back(point.area);
    return areas;
}

double length_of(const std::vector<PathPoint>& path) {
    double length = 0;
    for (std::size_t k = 1; k < path.size(); ++k) length += glm::distance(path[k - 1].place, path[k].place);
    return length;
}

double straightness_of(const std::vector<PathPoint>& path) {
    if (path.size() < 4) return 1;
    double along = 0;
    double all = 0;
    for (std::size_t k = 2; k < path.size(); ++k) {
        const glm::dvec2 before = path[k - 1].place - path[k - 2].place;
        const glm::dvec2 here = path[k].place - path[k - 1].place;
        along += glm::dot(before, here);
        all += glm::length(before) * glm::length(here);
    }
    return all > 0 ? along / all : 1;
}

glm::dvec2 place_at(const std::vector<PathPoint>& path, std::int64_t frame) {
    const auto next = std::ranges::lower_bound(path, frame, {}, [](const PathPoint& p) { return p.at.frame; });
    if (next == path.begin()) return path.front().place;
    if (next == path.end()) return path.back().place;
    const PathPoint& before = *(next - 1);
    const auto part =
        static_cast<double>(frame - before.at.frame) / static_cast<double>(next->at.frame - before.at.frame);
    return before.place + part * (next->place - before.place);
}

std::vector<PathPoint> thinned(std::vector<PathPoint> path) {
    if (path.size() < 2) return path;
    const PathPoint last = path.back();
    while (path.size() > most_points) halve(path);
    if (path.back().at.frame != last.at.frame) path.push_back(last);
    return path;
}

}  // namespace vvr::events
