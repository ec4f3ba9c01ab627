#include "core/scene/traceline.h"

#include <algorithm>
#include <cmath>

namespace vvr::scene {

namespace {

/// The part of the way from `from`, inside, to `to` that lies between `low` and `high`.
double inside_share(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& low, const glm::dvec3& high) {
    double share = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = to[axis] - from[axis];
        if (to[axis] > high[axis]) share = std::min(share, (high[axis] - from[axis]) / way);
        if (to[axis] < low[axis]) share = std::min(share, (low[axis] - from[axis]) / way);
    }
    return share;
}

/// Adds one line to the buffer, its points at least `spacing` apart but for the last.
void append(Tracelines& lines, const std::vector<TraceVertex>& points, double spacing) {
    const std::size_t begin = lines.size();
    float length = 0;
    lines.push_back(points.front());
    for (std::size_t i = 1; i < points.size(); ++i) {
        const float step = glm::distance(points[i].p, lines.back().p);
        const bool last = i + 1 == points.size();
        if (step == 0 || (step < spacing && !last)) continue;
        length += step;
        lines.push_back(points[i]);
        lines.back().along = length;
    }
    if (length == 0) {
        lines.resize(begin);
        return;
    }
    for (std::size_t i = begin; i < lines.size(); ++i) {
        lines[i].along /= length;
        lines[i].length = length;
    }
}

}  // namespace

std::vector<glm::dvec3> trace(const bricks::Volume& volume, const glm::dvec3& start, const TraceOptions& options) {
    const glm::dvec3 low(-0.5);
    const glm::dvec3 high = glm::dvec3(volume.size().width, volume.size().height,
                                       volume.is_nonuniform() ? volume.frames() : volume.layers() * volume.step()) -
                            0.5;
    std::vector<glm::dvec3> points = {start};
    for (int i = 0; i < options.steps; ++i) {
        const glm::dvec3 from = points.back();
        const glm::dvec2 flow = volume.flow().at(from);
        const glm::dvec3 step = glm::dvec3(flow, options.time_velocity) * options.dt;
        if (glm::length(flow) < options.rest || !(glm::length(step) > 0)) break;
        const double share = inside_share(from, from + step, low, high);
        points.push_back(glm::clamp(from + share * step, low, high));
        if (share < 1) break;
    }
    return points;
}

Tracelines tracelines(const bricks::Volume& volume, std::span<const bricks::FrameSeed> seeds,
                      const space::Layout& layout, const TraceOptions& options) {
    Tracelines lines;
    std::vector<TraceVertex> points;
    for (const bricks::FrameSeed& at : seeds) {
        points.clear();
        const glm::dvec3 start = {at.seed.x, at.seed.y, static_cast<double>(at.frame)};
        for (const glm::dvec3& point : trace(volume, start, options)) {
            const auto speed = static_cast<float>(glm::length(volume.flow().at(point)));
            points.push_back(
                {glm::vec3(layout.p_from_c(volume.c_of(point))), 0, 0, speed, static_cast<float>(point.z)});
        }
        append(lines, points, options.spacing);
    }
    return lines;
}

}  // namespace vvr::scene
