#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/image/picture.h"

namespace vvr::image {

/// The values of a picture file: any number of channels, pixel by pixel, rows from the top.
struct Samples {
    Size size;
    std::vector<std::string> channels;  ///< "R", "G", "B", "A", or the file's own names
    std::vector<float> values;          ///< integers of a file as 0..1
    Metadata attributes{};              ///< all that the file holds, as text

    /// The values of the pixel at column `i`, row `j`.
    std::span<const float> at(int i, int j) const {
        const auto place =
            static_cast<std::size_t>(j) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(i);
        return std::span(values).subspan(place * channels.size(), channels.size());
    }
};

/// Reads a PNG, JPEG, TIFF or OpenEXR file: what it is, its first bytes say, whatever its name. Of several pictures in
/// a file it reads the first.
/// \throws Error io for any other file, or one that is damaged; limit for a picture that is too large
Samples read_samples(const std::filesystem::path& path);

/// Reads a picture from the bytes of a file.
/// \param name for messages
/// \throws Error as above
Samples decode_samples(const std::filesystem::path& name, std::span<const std::byte> bytes);

/// The same without the channels of pixel data, which are indices and seconds, or NaN, and not intensities.
Samples without_pixel_data(Samples samples);

/// The type of a file's colour values.
enum class Stored { uint8, uint16, half };

/// Names and values of an encoder's options, in OpenImageIO's words.
using EncoderOptions = std::vector<std::pair<std::string, int>>;

/// libpng's numbers of the filters that prepare a row for compression.
namespace png_filter {
inline constexpr int none = 0x08;  ///< for what is mostly of one value
inline constexpr int sub = 0x10;   ///< differences from the left neighbour: for pictures nearly as small as the best of
                                   ///< all, chosen row by row, in half the time
}  // namespace png_filter

/// A picture file to encode.
struct PictureFile {
    std::string format;  ///< its ending, without the dot
    std::string name;    ///< for error messages
    Size size;
    int colours = 3;  ///< channels: 1 grey, 3 colour, 4 colour and alpha
    Stored stored = Stored::uint8;
    std::vector<std::string> pixel_data{};  ///< names of further channels, of floats
    Metadata attributes{};
    EncoderOptions options{};
    /// Pixel by pixel, rows from the top. 8-bit files take 8-bit values, with colours not multiplied by alpha; others
    /// take floats.
    std::span<const std::byte> values{};
};

/// What vvr uses of OpenImageIO. With the 250 libraries it depends on, it takes 0.2 s to load. So it is in a library of
/// our own, made of core/image/oiio.cpp, which is loaded with the first picture.
struct PictureCodec {
    /// The bytes of a picture file; same picture, same bytes.
    /// \throws Error io when OpenImageIO refuses
    std::vector<std::byte> (*encode)(const PictureFile& file);
    /// Reads a file, or its bytes where they are given, by the reader of one format. \throws Error io, or limit for a
    /// picture that is too large
    Samples (*read)(const std::filesystem::path& path, std::string_view format,
                    std::optional<std::span<const std::byte>> bytes);
    /// Reads 8-bit values of a PNG of this size and number of channels. \throws Error io for any other
    void (*read_bytes)(const std::filesystem::path& path, Size size, int channels, std::uint8_t* values);
};

/// Loads the library at the first call; from any thread.
/// \throws Error io when it can't be loaded
const PictureCodec& picture_codec();

/// The one name that the library exports, of a function that returns a pointer to the codec.
inline constexpr const char* picture_codec_symbol = "vvr_picture_codec";

}  // namespace vvr::image
