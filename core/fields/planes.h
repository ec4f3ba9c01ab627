#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/plane.h"

namespace vvr::fields {

/// Grey and, where there is any, colour of one picture.
struct Planes {
    Plane<std::uint8_t> grey;
    Plane<Bgr> colour;  ///< of the same size, or empty

    bool empty() const { return grey.empty(); }
};

/// How bright a colour is, 0 to 255: near luma, in whole numbers.
inline int brightness_of(const Bgr& colour) {
    return (colour[0] + 2 * colour[1] + colour[2]) / 4;
}

/// Smooths a picture with a Gaussian of `sigma` pixels; 0 leaves it as it is. Camera noise differs from pixel to pixel:
/// at the default of 0.7 it falls to a third, and objects keep their outlines.
Planes smoothed(const Plane<std::uint8_t>& grey, const Plane<Bgr>& colour, double sigma);

/// The largest of the channels' differences at each pixel, or grey's where one of them has no colour.
Plane<std::uint8_t> largest_difference(const Planes& a, const Planes& b);

/// One row of the table of norms: how much two pictures differ at a pixel, in levels 0 to 255.
struct NormRow {
    std::string_view name;
    std::string_view help;
    bool needs_colour;
    Plane<std::uint8_t> (*difference)(const Planes& a, const Planes& b);
};

/// The norms; the first is the default.
std::span<const NormRow> norms();

/// The same norm, for pictures like this one.
/// \throws Error usage when it needs colour and the picture has none
const NormRow& norm_for(const NormRow& norm, const Planes& picture);

}  // namespace vvr::fields
