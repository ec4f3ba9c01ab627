#include "core/scene/zebra.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr::scene {

Plane<std::uint8_t> zebra_texels() {
    // How many times the wave overshoots black and white: the part of the period that the borders take.
    constexpr double contrast = 3;
    Plane<std::uint8_t> texels({64, 1});
    for (int i = 0; i < texels.width(); ++i) {
        const double at = (i + 0.5) / texels.width();
        const double wave = contrast * std::sin(2 * std::numbers::pi * at);
        texels.at(i, 0) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5 + wave / 2, 0.0, 1.0)));
    }
    return texels;
}

}  // namespace vvr::scene
