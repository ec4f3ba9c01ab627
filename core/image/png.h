#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/image/picture_codec.h"

namespace vvr::image {

/// Most pixels per side of a PNG, for libpng.
inline constexpr int most_png_side = 1'000'000;

/// PNG files by libpng: those that are written have 8 bits per value; all others are read as well. Of an animation,
/// only the first picture is read.
const PictureCodec& png_codec();

/// Reads an 8-bit PNG of this size and number of channels.
/// \param values room for all of them, interleaved
/// \throws Error file_invalid for any other file, file_not_found, out_of_memory
void read_png_bytes(const std::filesystem::path& path, int channels, Size size, std::span<std::uint8_t> values);

}  // namespace vvr::image
