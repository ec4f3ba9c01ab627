#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/base/plane.h"

// The planes of an extraction as PNG files of 8 bits: grey, or red, green and blue.
namespace vvr::dataset {

std::vector<std::byte> encode_grey(const Plane<std::uint8_t>& plane);
std::vector<std::byte> encode_colour(const Plane<Bgr>& plane);

/// \throws Error io if the file can't be read, or has another format or size
Plane<std::uint8_t> read_grey(const std::filesystem::path& path, Size size);

/// \throws Error as `read_grey`
Plane<Bgr> read_colour(const std::filesystem::path& path, Size size);

}  // namespace vvr::dataset
