#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"

namespace vvr::image {

/// Encodes a picture as WebP. OpenImageIO would use the slowest method.
/// \param rgba interleaved; alpha is straight
/// \param quality 1..100
/// \throws Error io for a picture too large for WebP
std::vector<std::byte> encode_webp(std::span<const std::uint8_t> rgba, Size size, int quality);

}  // namespace vvr::image
