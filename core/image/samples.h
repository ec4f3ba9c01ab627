#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/image/picture.h"

namespace vvr::image {

/// The values of a picture file: any number of channels, pixel by pixel, rows from the top.
struct Samples {
    Size size;
    std::vector<std::string> channels;  ///< "R", "G", "B", "A", or the file's own names
    std::vector<float> values;          ///< integers of a file as 0..1
    Encoding encoding = Encoding::srgb;
    Metadata attributes{};  ///< all that the file holds, as text

    /// The values of the pixel at column `i`, row `j`.
    std::span<const float> at(int i, int j) const {
        const auto place =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i);
        return std::span(values).subspan(place * channels.size(), channels.size());
    }
};

/// Reads a PNG, JPEG, TIFF or OpenEXR file: what it is, its first bytes say, whatever its name. Of several pictures in
/// a file it reads the first. \throws Error io for any other file, or one that is damaged; limit for a picture that is
/// too large
Samples read_samples(const std::filesystem::path& path);

/// Reads a picture from the bytes of a file.
/// \param name for messages
/// \throws Error as above
Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes);

/// The same without the channels of pixel data, which are indices and seconds, or NaN, and not intensities.
Samples without_pixel_data(Samples samples);

}  // namespace vvr::image
