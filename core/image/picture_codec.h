#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/image/picture.h"

// What the libraries for picture files have in common. core/image/picture_file.h is for all who only have a picture.
namespace vvr::image {

/// The type of a file's colour values.
enum class Stored { uint8, uint16, half };

/// libpng's constants for row filters.
namespace png_filter {
inline constexpr int none = 0x08;  ///< for mostly uniform pictures
inline constexpr int sub = 0x10;   ///< difference from the left neighbour: nearly as small as adaptive filters, in half
                                   ///< the time
}  // namespace png_filter

/// A picture file to encode.
struct PictureFile {
    std::string format;  ///< file extension, without the dot
    std::string name;    ///< for error messages
    Size size;
    int colours = 3;  ///< channels: 1 grey, 3 colour, 4 colour and alpha
    Stored stored = Stored::uint8;
    bool srgb = false;                      ///< the file says that its colours are sRGB
    std::vector<std::string> pixel_data{};  ///< names of additional float channels
    Metadata attributes{};
    int png_level = 2;  ///< zlib's, 0..9
    int png_filter = png_filter::sub;
    int jpeg_quality = 95;  ///< 1..100
    /// Interleaved, top row first. 8-bit values with straight alpha for 8-bit formats, floats with premultiplied alpha
    /// for others.
    std::span<const std::byte> values{};
};

/// A picture file that is open, and its header. Whoever reads from it checks its size before.
struct PictureReader {
    PictureReader() = default;
    virtual ~PictureReader() = default;
    PictureReader(const PictureReader&) = delete;
    PictureReader& operator=(const PictureReader&) = delete;

    /// The file's texts; names are unique.
    virtual Metadata attributes() = 0;
    /// Reads all values, interleaved, as they are stored; integers are scaled to 0..1. Call it once.
    /// \param values room for `size` and `channels`
    /// \throws Error file_invalid, out_of_memory
    virtual void read(float* values) = 0;

    Size size{};                                  ///< 0x0 if it isn't one flat picture
    std::vector<std::string> channels{};          ///< their names
    std::optional<std::size_t> straight_alpha{};  ///< the channel by which colours aren't multiplied yet
};

/// The functions of a library for picture files.
struct PictureCodec {
    /// Encodes a picture file. The output is deterministic.
    /// \throws Error io if the library fails, out_of_memory
    std::vector<std::byte> (*encode)(const PictureFile& file);
    /// Opens a file, or `bytes` if given, which must outlive the reader, with the reader of one format.
    /// \throws Error file_invalid if it can't be read, out_of_memory
    std::unique_ptr<PictureReader> (*open)(const std::filesystem::path& path, std::string_view format,
                                           std::optional<std::span<const std::byte>> bytes);
};

/// All that uses OpenImageIO. It and its 250 dependencies take half a second of processor time to load. Therefore it is
/// in a library of its own (core/image/oiio.cpp), which is loaded at the first call. Thread-safe.
/// \throws Error io if it can't be loaded, out_of_memory
const PictureCodec& openimageio_codec();

/// The only symbol that the library exports: a function that returns a pointer to the codec.
inline constexpr const char* picture_codec_symbol = "vvr_picture_codec";

}  // namespace vvr::image
