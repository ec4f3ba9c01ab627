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

/// A number between 0 and 1 for each whole (i, j).
inline double hash(int i, int j) {
    auto h = static_cast<std::uint32_t>(i) * 374761393U + static_cast<std::uint32_t>(j) * 668265263U;
    h = (h ^ (h >> 13)) * 1274126177U;
    return ((h ^ (h >> 16)) & 0xffffU) / 65535.0;
}

/// Smooth noise with one bump in every unit.
inline double bumps(double x, double y) {
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const double s = x - i, t = y - j;
    const double u = s * s * (3 - 2 * s), v = t * t * (3 - 2 * t);
    return (hash(i, j) * (1 - u) + hash(i + 1, j) * u) * (1 - v) +
           (hash(i, j + 1) * (1 - u) + hash(i + 1, j + 1) * u) * v;
}

/// A texture of all sizes that repeats nowhere, so that fast motion can be told.
inline double rough_texture(double x, double y) {
    return 20 + 100 * bumps(x / 17 + 50, y / 17 + 50) + 70 * bumps(x / 7 + 90, y / 7 + 20) +
           45 * bumps(x / 3.1 + 300, y / 3.1 + 77);
}

/// Frame `index` of the texture moving by (u, v) pixels per frame.
inline video::Frame texture_frame(Size size, std::int64_t index, double u, double v) {
    const auto f = static_cast<double>(index);
    return {index, f / 10, grey_plane(size, [&](int i, int j) { return texture(i - u * f, j - v * f); }), {}};
}

/// A frame of one grey level.
inline video::Frame flat_frame(Size size, std::int64_t index, std::uint8_t level) {
    return {index, static_cast<double>(index) / 10, Plane<std::uint8_t>(size, level), {}};
}

}  // namespace vvr::test
