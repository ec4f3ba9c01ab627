#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/base/plane.h"

namespace vvr::store {

/// A plane of 8-bit values as a PNG picture in grey, lossless; same values, same bytes.
/// \throws Error io
std::vector<std::byte> encode_grey(const Plane<std::uint8_t>& plane);

/// The same in colour.
std::vector<std::byte> encode_colour(const Plane<Bgr>& plane);

/// \throws Error io for a file that can't be read, that isn't 8-bit with one channel, or has another size
Plane<std::uint8_t> read_grey(const std::filesystem::path& path, Size size);

/// The same for three channels.
Plane<Bgr> read_colour(const std::filesystem::path& path, Size size);

}  // namespace vvr::store
