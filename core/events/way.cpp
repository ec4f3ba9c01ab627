#include "core/events/way.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vvr::events {

namespace {

int whole(double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e8, 1e8)));
}

/// As a report writes it.
double told(double value) {
    return std::round(value * 1000) / 1000;
}

/// How far a point is from where the straight way from `a` to `b` has it at its moment.
double synchronized_distance(const Waypoint& a, const Waypoint& b, const Waypoint& point) {
    const double share = b.time > a.time ? static_cast<double>(point.time - a.time) / (b.time - a.time) : 0;
    return std::hypot(point.x - (a.x + share * (b.x - a.x)), point.y - (a.y + share * (b.y - a.y)));
}

/// Douglas and Peucker's way, by the distance at the same moment: marks what stays between two points that do.
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
    return {whole(told(seconds) * 10), whole((told(place.x) + 0.5) / size.x * 1000),
            whole((told(place.y) + 0.5) / size.y * 1000)};
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

}  // namespace vvr::events
