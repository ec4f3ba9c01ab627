#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>

#include "core/base/plane.h"

namespace vvr::test {

/// A plane whose value in column i and row j is `value(i, j)`.
template <class T, class Function>
Plane<T> plane_of(Size size, const Function& value) {
    Plane<T> plane(size);
    for (int j = 0; j < size.height; ++j) {
        for (int i = 0; i < size.width; ++i) plane.at(i, j) = value(i, j);
    }
    return plane;
}

/// Bytes without a pattern.
inline Plane<Bgr> noise(Size size, unsigned seed) {
    std::mt19937 random(seed);
    return plane_of<Bgr>(size, [&](int, int) {
        const auto byte = [&] { return static_cast<std::uint8_t>(random()); };
        return Bgr{byte(), byte(), byte()};
    });
}

/// How many pixels are not 0.
inline std::ptrdiff_t lit(const Plane<std::uint8_t>& plane) {
    return std::ranges::count_if(plane.pixels(), [](int p) { return p > 0; });
}

template <class T>
bool same(const Plane<T>& a, const Plane<T>& b) {
    return a.size() == b.size() && std::ranges::equal(a.pixels(), b.pixels());
}

}  // namespace vvr::test
