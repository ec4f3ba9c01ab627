#pragma once

#include <algorithm>

#include "core/base/plane.h"

namespace vvr::events {

/// What is seen at one moment: the field, and the frame of which it was made. The planes are of one size; a frame
/// without colour or without a picture leaves those empty, and then objects are told apart by what is left.
struct FrameView {
    const Plane<std::uint8_t>& field;  ///< 0 = nothing; else part of an object
    const Plane<std::uint8_t>& grey;
    const Plane<Bgr>& colour;

    Bgr at(int i, int j) const {
        if (!colour.empty()) return colour.at(i, j);
        const std::uint8_t value = grey.empty() ? field.at(i, j) : grey.at(i, j);
        return {value, value, value};
    }

    int brightness(int i, int j) const {
        const Bgr c = at(i, j);
        return (c[0] + 2 * c[1] + c[2]) / 4;
    }
};

}  // namespace vvr::events
