#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/image/picture.h"

namespace vvr {

/// How a PNG file's rows are prepared for compression.
enum class PngFilter {
    none,  ///< for what is mostly of one value
    sub,   ///< differences from the left neighbour: for pictures nearly as small as the best of all, chosen row by row,
           ///< in half the time
};

/// What is to become a PNG file: 8-bit sRGB values, rows from the top, colours not multiplied by alpha.
struct PngImage {
    Size size;
    int channels = 3;  ///< 1 grey, 3 colour, 4 colour and alpha
    std::span<const std::uint8_t> values;
    int level = 2;  ///< zlib's, 1 fastest to 9 smallest
    PngFilter filter = PngFilter::sub;
    Metadata texts{};  ///< keywords, of 1 to 79 characters, and texts in UTF-8
};

/// The bytes of a PNG file; same image, same bytes. libpng does it alone: OpenImageIO, which would call it too, takes
/// longer to load than a short clip to be read.
/// \throws Error io where libpng refuses
std::vector<unsigned char> encode_png(const PngImage& image);

}  // namespace vvr
