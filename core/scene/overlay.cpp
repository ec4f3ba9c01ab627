#include "core/scene/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/space/layout.h"

namespace vvr::scene {

namespace {

glm::dvec3 corner(const BoundingBox& box, int i) {
    return {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z};
}

LineSegment segment(const glm::dvec3& from, const glm::dvec3& to, const glm::vec4& colour) {
    return {glm::vec3(from), glm::vec3(to), colour};
}

/// The intersection of a box with the plane at `depth` from the camera, as a convex polygon.
std::vector<glm::dvec3> cut_box(const BoundingBox& box, const space::Camera& camera, double depth) {
    std::vector<glm::dvec3> points;
    glm::dvec3 middle(0);
    for (const auto& [a, b] : space::hexahedron_edges) {
        const glm::dvec3 from = corner(box, a);
        const glm::dvec3 to = corner(box, b);
        const double depth_from = glm::dot(from - camera.eye, camera.forward) - depth;
        const double depth_to = glm::dot(to - camera.eye, camera.forward) - depth;
        if ((depth_from >= 0) == (depth_to >= 0)) continue;
        points.push_back(glm::mix(from, to, depth_from / (depth_from - depth_to)));
        middle += points.back();
    }
    if (points.empty()) return points;
    middle /= static_cast<double>(points.size());
    const glm::dvec3 right = {camera.view[0][0], camera.view[1][0], camera.view[2][0]};
    const glm::dvec3 up = {camera.view[0][1], camera.view[1][1], camera.view[2][1]};
    std::ranges::sort(points, {}, [&](const glm::dvec3& point) {
        return std::atan2(glm::dot(point - middle, up), glm::dot(point - middle, right));
    });
    return points;
}

}  // namespace

BoundingBox layout_bounds(const space::Layout& layout) {
    BoundingBox box;
    for (const glm::dvec3& point : outline_points(layout)) box.add(point);
    return box;
}

BoundingBox visible_bounds(std::span<const bricks::PlacedCells> bricks, const space::Layout& layout,
                           const TransferFunction& transfer) {
    BoundingBox box;
    const bool zero_is_empty = !transfer.visible({0, 0});
    for (const bricks::PlacedCells& brick : bricks) {
        const bricks::BrickCells& cells = *brick.cells;
        for (int it = 0; it < cells.nt(); ++it) {
            for (int iy = 0; iy < cells.ny(); ++iy) {
                for (int ix = 0; ix < cells.nx(); ++ix) {
                    if (!transfer.visible(cells.range(ix, iy, it))) continue;
                    const bricks::CellBox part = cells.part(ix, iy, it, zero_is_empty);
                    for (int i = 0; i < 8; ++i) {
                        const double x = (i & 1) != 0 ? part.x_high : part.x_low;
                        const double y = (i >> 1 & 1) != 0 ? part.y_high : part.y_low;
                        const double t_b = cells.t[static_cast<std::size_t>(it + (i >> 2))];
                        box.add(layout.p_from_c({x, y, std::lerp(brick.t_begin, brick.t_end, t_b)}));
                    }
                }
            }
        }
    }
    return box;
}

std::vector<glm::dvec3> corners(const BoundingBox& box) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < 8; ++i) points.push_back(corner(box, i));
    return points;
}

std::vector<LineSegment> box_edges(const BoundingBox& box, const glm::vec4& colour) {
    std::vector<LineSegment> segments;
    if (box.empty()) return segments;
    for (const auto& [a, b] : space::hexahedron_edges)
        segments.push_back(segment(corner(box, a), corner(box, b), colour));
    return segments;
}

std::vector<LineSegment> slice_outlines(const BoundingBox& box, const space::Camera& camera, const SliceStack& stack,
                                        int shown, const glm::vec4& colour) {
    std::vector<LineSegment> segments;
    if (box.empty()) return segments;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec3& point : corners(box)) {
        const double depth = (glm::dot(point - camera.eye, camera.forward) - stack.nearest) / stack.spacing;
        low = std::min(low, depth);
        high = std::max(high, depth);
    }
    const int first = std::max(0, static_cast<int>(std::ceil(low)));
    const int last = std::min(stack.count - 1, static_cast<int>(std::floor(high)));
    const int step = std::max(1, (last - first + 1) / shown);
    for (int slice = first; slice <= last; slice += step) {
        const auto polygon = cut_box(box, camera, stack.nearest + slice * stack.spacing);
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            segments.push_back(segment(polygon[i], polygon[(i + 1) % polygon.size()], colour));
        }
    }
    return segments;
}

}  // namespace vvr::scene
