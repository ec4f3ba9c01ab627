#include "core/scene/zebra.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vvr {

std::array<std::uint8_t, 64> zebra_texels() {
    // How many times the wave overshoots black and white: the part of the period that the borders take.
    constexpr double contrast = 3;
    std::array<std::uint8_t, 64> texels;
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const double at = (static_cast<double>(i) + 0.5) / static_cast<double>(texels.size());
        const double wave = contrast * std::sin(2 * std::numbers::pi * at);
        texels[i] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(0.5 + wave / 2, 0.0, 1.0)));
    }
    return texels;
}

}  // namespace vvr
