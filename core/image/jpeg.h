#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/plane.h"

// Pictures kept in memory as JPEG. They never leave the process: `encode_picture` makes files.
namespace vvr::image {

/// Compresses a picture to about a tenth, nearly without loss. The output is deterministic.
/// \throws Error io if libav has no encoder, out_of_memory
std::vector<std::byte> compress(const Plane<Bgr>& picture);

/// \param jpeg from `compress`
/// \throws Error io, out_of_memory
Plane<Bgr> decompress(std::span<const std::byte> jpeg);

}  // namespace vvr::image
