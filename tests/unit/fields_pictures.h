#pragma once

#include <cmath>
#include <cstdint>

#include "core/video/frame.h"

namespace vvr::test {

/// A grey plane whose value at each pixel is `value(i, j)`, rounded and cut to 0..255.
template <class Function>
Plane<std::uint8_t> grey_plane(Size size, Function value) {
    Plane<std::uint8_t> plane(size);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) {
            plane.at(i, j) = static_cast<std::uint8_t>(std::lround(std::fmin(std::fmax(value(i, j), 0), 255)));
        }
    }
    return plane;
}

/// A texture of several wavelengths and directions, 8 px and longer, so that no direction of motion is hidden.
inline double texture(double x, double y) {
    return 128 + 40 * std::sin(x * 0.41 + y * 0.23) + 35 * std::sin(x * 0.19 - y * 0.37 + 1) +
           25 * std::sin(x * 0.53 - y * 0.07 + 2) + 20 * std::sin(x * 0.05 + y * 0.61);
}

/// Frame `index` of the texture moving by (u, v) pixels a frame.
inline Frame texture_frame(Size size, std::int64_t index, double u, double v) {
    const auto f = static_cast<double>(index);
    return {index, f / 10, grey_plane(size, [&](int i, int j) { return texture(i - u * f, j - v * f); }), {}};
}

/// A frame of one grey level.
inline Frame flat_frame(Size size, std::int64_t index, std::uint8_t level) {
    return {index, static_cast<double>(index) / 10, Plane<std::uint8_t>(size, level), {}};
}

}  // namespace vvr::test
