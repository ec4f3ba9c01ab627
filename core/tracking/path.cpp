#include "core/tracking/path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/text.h"
#include "core/tracking/event_options.h"

namespace vvr::tracking {

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

const Heading& heading_of(std::span<const PathPoint> path, double length) {
    const glm::dvec2 way = path.back().place - path.front().place;
    glm::dvec2 low = path.front().place;
    glm::dvec2 high = low;
    for (const PathPoint& point : path) {
        low = glm::min(low, point.place);
        high = glm::max(high, point.place);
    }
    // Somebody who paced, and left at the other side, went there.
    if (glm::length(way) < 0.2 * length && glm::length(way) < 0.25 * glm::distance(low, high)) return to_and_fro;
    const double eighths = std::atan2(way.y, way.x) / (2 * std::numbers::pi) * 8;
    return headings.at(static_cast<std::size_t>(std::lround(eighths) + 8) % headings.size());
}

const Heading* find_heading(std::string_view name) {
    if (name == to_and_fro.name) return &to_and_fro;
    const auto found = std::ranges::find(headings, name, &Heading::name);
    return found == headings.end() ? nullptr : &*found;
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

void Stays::add(const Moment& now, const glm::dvec2& place, const PixelBox& box, double reach) {
    if (open_ && glm::distance(place, open_->place) <= reach) {
        open_->last = now;
        ++sightings_;
        return;
    }
    close();
    open_ = Stay{now, now, place, box};
    sightings_ = 1;
}

void Stays::add_exactly(const Stay& stay) {
    open_.reset();
    if (stay.last.seconds - stay.first.seconds < least_) return;
    std::erase_if(found_, [&](const Stay& other) { return other.last.frame >= stay.first.frame; });
    found_.push_back(stay);
}

std::vector<Stay> Stays::finish() {
    close();
    return std::move(found_);
}

void Stays::close() {
    const bool lasts = open_ && open_->last.seconds - open_->first.seconds >= least_;
    if (lasts && sightings_ > thresholds.stationary.sightings) found_.push_back(*open_);
    open_.reset();
}

namespace {

int whole(double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e8, 1e8)));
}

/// The synchronized distance: from a point to the place at the same moment on the straight way from `a` to `b`.
double synchronized_distance(const Waypoint& a, const Waypoint& b, const Waypoint& point) {
    const double share = b.time > a.time ? static_cast<double>(point.time - a.time) / (b.time - a.time) : 0;
    return std::hypot(point.x - (a.x + share * (b.x - a.x)), point.y - (a.y + share * (b.y - a.y)));
}

/// The Douglas-Peucker algorithm with synchronized distance: marks the points to keep.
void mark_kept(std::span<const Waypoint> way, double tolerance, std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, way.size() - 1}};
    while (!parts.empty()) {
        const auto [begin, end] = parts.back();
        parts.pop_back();
        double farthest = tolerance;
        std::size_t at = begin;
        for (std::size_t k = begin + 1; k < end; ++k) {
            const double off = synchronized_distance(way[begin], way[end], way[k]);
            if (off <= farthest) continue;
            farthest = off;
            at = k;
        }
        if (at == begin) continue;
        kept[at] = true;
        parts.emplace_back(begin, at);
        parts.emplace_back(at, end);
    }
}

}  // namespace

Waypoint waypoint(double seconds, const glm::dvec2& place, const glm::dvec2& size) {
    return {whole(rounded(seconds) * 10), whole((rounded(place.x) + 0.5) / size.x * 1000),
            whole((rounded(place.y) + 0.5) / size.y * 1000)};
}

std::vector<Waypoint> simplified(std::span<const Waypoint> way, double tolerance) {
    if (way.size() < 3) return {way.begin(), way.end()};
    std::vector<bool> kept(way.size());
    kept.front() = kept.back() = true;
    mark_kept(way, tolerance, kept);
    std::vector<Waypoint> points;
    for (std::size_t k = 0; k < way.size(); ++k) {
        if (kept[k]) points.push_back(way[k]);
    }
    return points;
}

}  // namespace vvr::tracking
