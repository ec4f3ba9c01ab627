#pragma once

#include <cstdint>
#include <span>

#include "core/base/plane.h"

extern "C" {
#include <libavutil/pixfmt.h>
}

namespace vvr::kernels {

/// The chroma factors of the conversion from luma and chroma to BGR, in units of 1/8192.
struct ColourMatrix {
    /// \param full_range whether chroma uses the full range 0 to 255
    ColourMatrix(AVColorSpace space, bool full_range);

    std::int16_t red_of_cr = 0;
    std::int16_t blue_of_cb = 0;
    std::int16_t green_of_cb = 0;
    std::int16_t green_of_cr = 0;

    friend bool operator==(const ColourMatrix&, const ColourMatrix&) = default;
};

/// Converts a row of full-range luma and chroma to BGR in fixed point, with the same result on every machine. All spans
/// have the same length.
void to_bgr(const ColourMatrix& matrix, std::span<const std::uint8_t> luma, std::span<const std::uint8_t> cb,
            std::span<const std::uint8_t> cr, std::span<Bgr> out);

/// Converts a row of luma from 16…235 to 0…255; values outside are clipped.
void to_full_range(std::span<const std::uint8_t> luma, std::span<std::uint8_t> out);

}  // namespace vvr::kernels
