#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/plane.h"

namespace vvr {

/// What is to become a JPEG file: red, green and blue of 8 bits, rows from the top.
struct JpegImage {
    Size size;
    std::span<const std::uint8_t> values;
    int quality = 95;       ///< 1..100
    std::string comment{};  ///< left out where empty
};

/// The bytes of a JPEG file; same image, same bytes. By libjpeg alone, for the reason that png_encoder.h gives.
/// \throws Error io where libjpeg refuses, as it does a side of more than 65,500 pixels; limit when there is no memory
std::vector<unsigned char> encode_jpeg(const JpegImage& image);

}  // namespace vvr
