#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/image/picture.h"
#include "core/image/samples.h"

namespace vvr {

/// How a channel's values stand in a file.
enum class Stored { uint8, uint16, half };

/// A picture file that is to be encoded.
struct PictureFile {
    std::string format;  ///< its ending, without the dot
    std::string name;    ///< for what the library says of it
    Size size;
    int colours = 3;  ///< channels
    Stored stored = Stored::uint8;
    std::vector<std::string> layers{};  ///< names of further channels of floats
    Metadata attributes{};
    std::span<const float> values{};
};

/// What we use of OpenImageIO: all formats but PNG and JPEG, and all that is read. Together with the 250 libraries that
/// it depends on it takes longer to load than a short clip to be read, so it stands in a library of our own,
/// core/image/oiio.cpp, that is loaded when it is first needed.
struct PictureCodec {
    std::vector<unsigned char> (*encode)(const PictureFile& file);
    Samples (*read)(const std::filesystem::path& path);
    Samples (*decode)(const std::filesystem::path& name, std::span<const unsigned char> bytes);
    Metadata (*attributes)(const std::filesystem::path& path);
    /// 8-bit values of a file that has to have this size and so many channels.
    void (*read_bytes)(const std::filesystem::path& path, Size size, int channels, std::uint8_t* values);
};

/// Loads it at the first call; from any thread.
/// \throws Error io where it isn't beside the program, or a library that it depends on is missing
const PictureCodec& picture_codec();

/// The one name that the library gives away, that of a function that returns a pointer to the codec.
inline constexpr const char* picture_codec_symbol = "vvr_picture_codec";

}  // namespace vvr
