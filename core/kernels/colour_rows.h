#pragma once

#include <cstdint>
#include <span>

#include "core/base/plane.h"

extern "C" {
#include <libavutil/pixfmt.h>
}

namespace vvr::kernels {

/// From luma and chroma to blue, green and red, as factors of chroma in 1/8192.
struct ColourMatrix {
    /// \param full_range whether chroma uses all of 0..255
    ColourMatrix(AVColorSpace space, bool full_range);

    std::int16_t red_of_cr = 0;
    std::int16_t blue_of_cb = 0;
    std::int16_t green_of_cb = 0;
    std::int16_t green_of_cr = 0;

    friend bool operator==(const ColourMatrix&, const ColourMatrix&) = default;
};

/// A row of full-range luma and of chroma to BGR, in fixed point: the same on every machine. All spans are as long.
void to_bgr(const ColourMatrix& matrix, std::span<const std::uint8_t> luma, std::span<const std::uint8_t> cb,
            std::span<const std::uint8_t> cr, std::span<Bgr> out);

/// A row of luma of 16..235 to 0..255; what lies outside is cut off.
void to_full_range(std::span<const std::uint8_t> luma, std::span<std::uint8_t> out);

}  // namespace vvr::kernels
