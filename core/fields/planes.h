#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/plane.h"

namespace vvr::fields {

/// The grey levels and, if any, the colours of a picture.
struct Planes {
    Plane<std::uint8_t> grey;
    Plane<Bgr> colour;  ///< of the same size; may be empty

    bool empty() const { return grey.empty(); }
};

/// Brightness of a colour, 0 to 255: integer approximation of luma.
inline int brightness_of(const Bgr& colour) {
    return (colour[0] + 2 * colour[1] + colour[2]) / 4;
}

/// Whether a picture has colours: its usual tint is more than slight, or more than one in twenty of its pixels have
/// another. An infrared camera writes grey frames into a video with colour channels, often with a slight tint.
bool has_colours(const Plane<Bgr>& picture);

/// Whether most parts of a picture have colours, so that they are those of the scene: a red car in the fog fills few.
bool has_colours_everywhere(const Plane<Bgr>& picture);

/// Gaussian smoothing with σ = `sigma` pixels; 0 = none. Camera noise is uncorrelated between pixels: the default of
/// 0.7 reduces it to a third, and objects keep their outlines.
Planes smoothed(const Plane<std::uint8_t>& grey, const Plane<Bgr>& colour, double sigma);

/// The largest difference of the colour channels per pixel; that of grey if either picture has no colour.
Plane<std::uint8_t> largest_difference(const Planes& a, const Planes& b);

/// One row of the table of norms: the difference of two pictures per pixel, levels 0 to 255.
struct NormRow {
    std::string_view name;
    std::string_view help;
    bool needs_colour;
    Plane<std::uint8_t> (*difference)(const Planes& a, const Planes& b);
};

/// The norms; the first is the default.
std::span<const NormRow> norms();

/// Returns `norm` if it can be used for this picture.
/// \throws Error usage if it needs colour and the picture has none
const NormRow& norm_for(const NormRow& norm, const Planes& picture);

}  // namespace vvr::fields
