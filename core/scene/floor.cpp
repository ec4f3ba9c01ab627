#include <algorithm>
#include <vector>

#include "core/scene/object_looks.h"
#include "core/scene/scene.h"

namespace vvr::scene {

namespace {

// From here on a value casts a whole shadow.
constexpr int strong = 64;

// Of an object's shadow: what is left of its colour, and its opacity. A stronger one would be taken for the object.
constexpr float colour_part = 0.75F;
constexpr float tinted_opacity = 0.3F;

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(value * 255 + 0.5F);
}

Bgr bgr_of(const glm::vec3& colour) {
    return {byte_of(colour.b), byte_of(colour.g), byte_of(colour.r)};
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
    const std::vector<glm::vec4> looks = object_palette(theme);
    shadow.colour.a = std::max(theme.shadow.a, tinted_opacity);
    const float nobodys_part = theme.shadow.a / shadow.colour.a;
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
            const bool is_asked = owner != 0 && identify;
            const bricks::Identity identity = is_asked ? identify(volume.track_of(owner), layer) : bricks::Identity{};
            if (identity.look != 0) {
                const glm::vec3 colour(looks[identity.look]);
                shadow.tint.at(i, row) = bgr_of(glm::mix(untinted, colour, colour_part));
            } else {
                std::uint8_t& darkness = shadow.darkness.at(i, row);
                darkness = byte_of(static_cast<float>(darkness) / 255 * nobodys_part);
            }
        }
    }
    return shadow;
}

}  // namespace vvr::scene
