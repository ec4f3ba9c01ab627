#include "core/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vvr::scene {

namespace {

// Layers of unequal length have no frame numbers of their own: count shares of a layer instead.
constexpr std::int64_t shares_per_layer = 64;

}  // namespace

TimeTable::TimeTable(const volume::Volume& volume)
    : step_(volume.is_nonuniform() ? shares_per_layer : volume.step()), nonuniform_(volume.is_nonuniform()) {
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const volume::Layer& layer = volume.layer(i);
        layers_.push_back({layer.first_frame, layer.last_frame, layer.frames, layer.pts, layer.last_pts});
    }
}

Moment TimeTable::at(double frame) const {
    if (empty()) return {};
    const std::int64_t in_last = nonuniform_ ? step_ : layers_.back().frames;
    const std::int64_t last = step_ * (static_cast<std::int64_t>(layers_.size()) - 1) + in_last - 1;
    const std::int64_t number = std::clamp<std::int64_t>(std::llround(frame), 0, last);
    const Entry& layer = layers_[static_cast<std::size_t>(number / step_)];
    const std::int64_t within = number % step_;
    const std::int64_t count = nonuniform_ ? step_ : layer.frames;
    const double share = layer.frames > 1 ? static_cast<double>(within) / static_cast<double>(count - 1) : 0;
    const double clip_frame =
        std::lerp(static_cast<double>(layer.first_frame), static_cast<double>(layer.last_frame), share);
    return {std::llround(clip_frame), std::lerp(layer.begin, layer.end, share)};
}

namespace {

// Values from here on cast a full shadow.
constexpr int strong = 64;

// An object's shadow: the share of the object's colour, and the opacity. A stronger shadow would look like an object.
constexpr float colour_part = 0.75F;
constexpr float tinted_opacity = 0.3F;

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround(value * 255));
}

}  // namespace

FloorShadow floor_shadow(const volume::Volume& volume, const glm::vec4& colour) {
    FloorShadow shadow;
    shadow.t_end = volume.t_end();
    shadow.colour = colour;
    shadow.darkness = Plane<std::uint8_t>({volume.size().width, static_cast<int>(volume.layers())});
    for (int row = 0; row < shadow.darkness.height(); ++row) {
        const auto into = shadow.darkness.row(row);
        volume.layer(row).scalar.for_each_run([&](int column, int, std::span<const std::uint8_t> values) {
            const auto under = into.subspan(static_cast<std::size_t>(column), values.size());
            std::ranges::transform(under, values, under.begin(), [&](std::uint8_t dark, std::uint8_t value) {
                return std::max(dark, value != 0 && !fields::interpolates(volume.values()) ? std::uint8_t{255} : value);
            });
        });
        std::ranges::transform(into, into.begin(), [](std::uint8_t value) {
            return static_cast<std::uint8_t>(std::min<int>(value, strong) * 255 / strong);
        });
    }
    return shadow;
}

FloorShadow floor_shadow(const volume::Volume& volume, const Theme& theme, const volume::VoxelStyleLookup& identify) {
    FloorShadow shadow = floor_shadow(volume, theme.shadow);
    const glm::vec3 untinted(theme.shadow);
    const std::vector<glm::vec4> palette = object_palette(theme);
    shadow.colour.a = std::max(theme.shadow.a, tinted_opacity);
    const float unowned_part = theme.shadow.a / shadow.colour.a;
    shadow.tint = Plane<Bgr>(shadow.darkness.size(), bgr_of(untinted));
    struct Strongest {
        std::uint8_t value = 0;
        std::uint16_t owner = 0;
    };
    std::vector<Strongest> columns;
    for (int row = 0; row < shadow.darkness.height(); ++row) {
        const volume::Layer& layer = volume.layer(row);
        columns.assign(static_cast<std::size_t>(shadow.darkness.width()), {});
        layer.scalar.for_each_run([&](int column, int j, std::span<const std::uint8_t> values) {
            for (const std::uint8_t value : values) {
                Strongest& strongest = columns[static_cast<std::size_t>(column)];
                if (value > strongest.value) strongest = {value, layer.owner.at(column, j)};
                ++column;
            }
        });
        for (int i = 0; i < shadow.darkness.width(); ++i) {
            const std::uint16_t owner = columns[static_cast<std::size_t>(i)].owner;
            const bool has_owner = owner != 0 && identify;
            const volume::VoxelStyle identity =
                has_owner ? identify(volume.track_of(owner), layer) : volume::VoxelStyle{};
            if (identity.look != 0) {
                const glm::vec3 colour(palette[identity.look]);
                shadow.tint.at(i, row) = bgr_of(glm::mix(untinted, colour, colour_part));
            } else {
                std::uint8_t& darkness = shadow.darkness.at(i, row);
                darkness = byte_of(static_cast<float>(darkness) / 255 * unowned_part);
            }
        }
    }
    return shadow;
}

std::vector<LineSegment> cross_section(const space::Layout& layout, double t, const glm::vec4& colour) {
    const auto corner = [&](double x, double y) { return glm::vec3(layout.p_from_c({x, y, t})); };
    const glm::vec3 corners[] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    std::vector<LineSegment> border;
    for (std::size_t i = 0; i < 4; ++i) border.push_back({corners[i], corners[(i + 1) % 4], colour});
    return border;
}

std::vector<LineSegment> volume_outline(const space::Layout& layout, const glm::vec4& colour) {
    constexpr int steps = 96;
    std::vector<LineSegment> segments;
    const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) {
        segments.push_back({glm::vec3(layout.p_from_c(from)), glm::vec3(layout.p_from_c(to)), colour});
    };
    for (int corner = 0; corner < 4; ++corner) {
        const double x = corner & 1;
        const double y = corner >> 1;
        for (int i = 0; i < steps; ++i) {
            add({x, y, static_cast<double>(i) / steps}, {x, y, static_cast<double>(i + 1) / steps});
        }
        add({x, 0, y}, {x, 1, y});  // upright edges at both ends
        add({0, x, y}, {1, x, y});
    }
    return segments;
}

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

BoundingBox visible_bounds(std::span<const volume::PlacedCells> bricks, const space::Layout& layout,
                           const TransferFunction& transfer) {
    BoundingBox box;
    const bool zero_is_empty = !transfer.visible({0, 0});
    for (const volume::PlacedCells& brick : bricks) {
        const volume::BrickCells& cells = *brick.cells;
        for (int it = 0; it < cells.nt(); ++it) {
            for (int iy = 0; iy < cells.ny(); ++iy) {
                for (int ix = 0; ix < cells.nx(); ++ix) {
                    if (!transfer.visible(cells.range(ix, iy, it))) continue;
                    const volume::CellBox part = cells.part(ix, iy, it, zero_is_empty);
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
