#include <algorithm>

#include "core/scene/scene.h"

namespace vvr {

namespace {

// From here on a value casts a whole shadow.
constexpr int strong = 64;

}  // namespace

FloorShadow floor_shadow(const Volume& volume, const glm::vec4& colour) {
    FloorShadow shadow;
    shadow.t_end = volume.t_end();
    shadow.colour = colour;
    shadow.darkness = Plane<std::uint8_t>({volume.size().width, static_cast<int>(volume.layers())});
    for (int row = 0; row < shadow.darkness.height(); ++row) {
        const auto into = shadow.darkness.row(row);
        volume.layer(row).scalar.each_run([&](int column, int, std::span<const std::uint8_t> values) {
            const auto under = into.subspan(static_cast<std::size_t>(column), values.size());
            std::ranges::transform(under, values, under.begin(), std::ranges::max);
        });
        std::ranges::transform(into, into.begin(), [](std::uint8_t value) {
            return static_cast<std::uint8_t>(std::min<int>(value, strong) * 255 / strong);
        });
    }
    return shadow;
}

}  // namespace vvr
