#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/events/patch.h"

namespace vvr::events {

/// How strong the edges of a picture are along the outline of a patch: the mean change of brightness across it, grey
/// levels. A thing has its edges in the frame. A ghost, the place of something that belonged to the empty scene and
/// went, has them in the empty scene; a patch of light has them in neither.
/// \param brightness of a column and a row of the picture, 0 to 255
template <class Brightness>
double edge_strength(const Patch& patch, Size picture, Brightness brightness) {
    constexpr int across = 2;  // pixels to each side: the field is smooth, and the outline is not exact
    double sum = 0;
    int count = 0;
    const auto at = [&](int i, int j) {
        return int{brightness(std::clamp(i, 0, picture.width - 1), std::clamp(j, 0, picture.height - 1))};
    };
    for_each_pixel(patch, [&](int i, int j, std::uint8_t) {
        const bool left = patch.at(i - 1, j) == 0;
        const bool right = patch.at(i + 1, j) == 0;
        const bool above = patch.at(i, j - 1) == 0;
        const bool below = patch.at(i, j + 1) == 0;
        if (!left && !right && !above && !below) return;
        const int dx = left || right ? std::abs(at(i + across, j) - at(i - across, j)) : 0;
        const int dy = above || below ? std::abs(at(i, j + across) - at(i, j - across)) : 0;
        sum += std::max(dx, dy);
        ++count;
    });
    return sum / std::max(1, count);
}

}  // namespace vvr::events
