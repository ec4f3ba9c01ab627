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
        const Plane<std::uint8_t>& scalar = volume.layer(row).scalar;
        const auto into = shadow.darkness.row(row);
        for (int j = 0; j < scalar.height(); ++j) {
            const auto values = scalar.row(j);
            for (std::size_t i = 0; i < into.size(); ++i) into[i] = std::max(into[i], values[i]);
        }
        std::ranges::transform(into, into.begin(), [](std::uint8_t value) {
            return static_cast<std::uint8_t>(std::min<int>(value, strong) * 255 / strong);
        });
    }
    return shadow;
}

}  // namespace vvr
