#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/image/picture_codec.h"

namespace vvr::image {

/// Most pixels per side of a JPEG file.
inline constexpr int most_jpeg_side = 65500;

/// JPEG files: written by libjpeg-turbo, in colour and with `Software` and `ImageDescription` as Exif; read by
/// OpenImageIO.
const PictureCodec& jpeg_codec();

/// Compresses a picture that stays in memory, to about a tenth and nearly without loss. The output is deterministic.
/// \throws Error io if the library fails, out_of_memory
std::vector<std::byte> compress(const Plane<Bgr>& picture);

/// \param jpeg from `compress`
/// \throws Error io, out_of_memory
Plane<Bgr> decompress(std::span<const std::byte> jpeg);

}  // namespace vvr::image
