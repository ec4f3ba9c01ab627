#pragma once

#include <algorithm>

#include "core/base/plane.h"

namespace vvr {

/// Part of a picture or a field: columns left to right - 1, rows top to bottom - 1.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }
    int width() const { return right - left; }
    int height() const { return bottom - top; }
    Size size() const { return {width(), height()}; }

    PixelBox translated(int x, int y) const { return {left + x, top + y, right + x, bottom + y}; }
    PixelBox inflated(int x, int y) const { return {left - x, top - y, right + x, bottom + y}; }

    bool contains(const PixelBox& other) const {
        return other.left >= left && other.right <= right && other.top >= top && other.bottom <= bottom;
    }
    bool intersects(const PixelBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }

    friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

/// The least box that holds both; an empty one adds nothing.
inline PixelBox bounding_box(const PixelBox& a, const PixelBox& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::min(a.top, b.top), std::max(a.right, b.right), std::max(a.bottom, b.bottom)};
}

/// What two boxes have in common; empty where they don't meet.
inline PixelBox intersection(const PixelBox& a, const PixelBox& b) {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

}  // namespace vvr
