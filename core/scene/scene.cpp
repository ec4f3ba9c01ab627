#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scene/theme.h"

namespace vvr::scene {

namespace {

// Layers of unequal length have no frame numbers of their own: count shares of a layer instead.
constexpr std::int64_t shares_per_layer = 64;

}  // namespace

TimeTable::TimeTable(const bricks::Volume& volume)
    : step_(volume.is_nonuniform() ? shares_per_layer : volume.step()), nonuniform_(volume.is_nonuniform()) {
    for (std::int64_t i = 0; i < volume.layers(); ++i) {
        const bricks::Layer& layer = volume.layer(i);
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
    return static_cast<std::uint8_t>(value * 255 + 0.5F);
}

}  // namespace

FloorShadow floor_shadow(const bricks::Volume& volume, const glm::vec4& colour) {
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

FloorShadow floor_shadow(const bricks::Volume& volume, const Theme& theme, const bricks::Identify& identify) {
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
        const bricks::Layer& layer = volume.layer(row);
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
            const bricks::Identity identity = has_owner ? identify(volume.track_of(owner), layer) : bricks::Identity{};
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

}  // namespace vvr::scene
