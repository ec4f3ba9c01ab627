#pragma once

#include <cstdint>
#include <filesystem>

#include "core/base/plane.h"

namespace vvr::dataset {

/// Reads a scalar field that another program wrote, as a picture with one channel: PNG, TIFF or OpenEXR. Black or 0 is
/// 0, white or 1 is 255, and everything between is rounded.
/// \throws Error io for a picture that can't be read, has another size, several channels, or a value outside of 0..1
Plane<std::uint8_t> read_scalar(const std::filesystem::path& file, Size size);

}  // namespace vvr::dataset
