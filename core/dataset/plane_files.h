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

/// Reads a scalar field that another program wrote, as a picture with one channel: PNG, TIFF or OpenEXR. Black or 0 is
/// 0, white or 1 is 255, and everything between is rounded.
/// \throws Error io for a picture that can't be read, has another size, several channels, or a value outside of 0..1
Plane<std::uint8_t> read_scalar(const std::filesystem::path& file, Size size);

}  // namespace vvr::dataset
