#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/plane.h"

namespace vvr {

/// A plane of bytes at twice its width and height, linear between the old points, which lie between the new ones:
/// chroma of 4:2:0 at luma's size. cv::resize takes several times as long. \param from
/// size.height rows, `stride` bytes apart \param to 4 * size.width * size.height bytes, row by row
void double_plane(Size size, const std::uint8_t* from, std::size_t stride, std::span<std::uint8_t> to);

}  // namespace vvr
