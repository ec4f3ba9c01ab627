#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/picture.h"

namespace vvr::image {

/// The pixel values of a picture file with any number of channels: interleaved, top row first.
struct Samples {
    Size size;
    std::vector<std::string> channels;  ///< "R", "G", "B", "A", or the file's own names
    std::vector<float> values;          ///< integers are scaled to 0..1
    Metadata attributes{};              ///< the file's attributes as text; of a PNG, its texts

    /// The values of the pixel at column `i`, row `j`.
    std::span<const float> at(int i, int j) const {
        const auto place =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i);
        return std::span(values).subspan(place * channels.size(), channels.size());
    }
};

/// Reads a PNG, JPEG, TIFF or OpenEXR file. The first bytes determine the format, not the name. Reads only the first of
/// several pictures.
/// \throws Error io if the file is damaged or has another format, limit if the picture is too large
Samples read_samples(const std::filesystem::path& path);

/// Reads a picture file with one channel, as above. Its size is checked before its pixels are read.
/// \throws Error as above, and io if it has another size or several channels
Plane<float> read_grey_samples(const std::filesystem::path& path, Size size);

/// Reads a picture file in memory.
/// \param name file name for messages
/// \throws Error as `read_samples`
Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes);

/// Removes the pixel data channels, whose values are indices, seconds or NaN, not intensities.
Samples without_pixel_data(Samples samples);

/// The extensions of picture files that can be written, with their dots.
std::vector<std::string> picture_file_extensions();

/// Checks that the extension of `path` is a known format.
/// \throws Error usage if it isn't
void check_picture_extension(const std::filesystem::path& path);

/// Checks that `write_picture` can write to `path`, before any long work.
/// \throws Error usage for an unknown extension, io if the folder doesn't exist or isn't writable
void check_picture_path(const std::filesystem::path& path);

/// Whether the format of `path` can hold pixel data.
bool holds_pixel_data(const std::filesystem::path& path);

/// Encodes a picture file in the format of `path`'s extension, with its settings and, if the format can hold it, its
/// pixel data in the channels `Z`, `time`, `frame` and `object`. The output is deterministic and has no date.
/// \param picture move it here: it is freed before encoding, to save memory
/// \param jpeg_quality 1..100
/// \throws Error usage for an unknown extension, io for a picture too large for the format
std::vector<std::byte> encode_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata = {},
                                      int jpeg_quality = 95);

/// Encodes a frame in an 8-bit format.
std::vector<std::byte> encode_picture(const std::filesystem::path& path, const Plane<Bgr>& picture,
                                      int jpeg_quality = 95);

/// Encodes a picture as WebP with transparency, for web pages.
/// \param quality 1..100
/// \throws Error io for a picture too large for WebP
std::vector<std::byte> encode_webp(const Plane<Rgba>& pixels, int quality);

/// Encodes a picture and replaces `path` atomically.
/// \throws Error usage or io, as `check_picture_path`, and io if the disk is full
void write_picture(const std::filesystem::path& path, Picture picture, const Metadata& metadata = {});

/// The settings that `write_picture` stored in a file.
Metadata settings_of(const Samples& file);

}  // namespace vvr::image
