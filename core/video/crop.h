#pragma once

#include "core/base/plane.h"
#include "core/video/frame.h"

namespace vvr::video {

/// A part of a frame in full size: cut out of the decoded picture, turned upright, with square pixels. If the frame has
/// no decoded picture, or one no larger than the field, or it can't be converted, the part comes from the frame itself.
/// Thread-safe.
/// \param box within the frame, in field pixels
/// \param longest_side in pixels; a larger part is shrunk by area averaging
Plane<Bgr> crop_of(const Frame& frame, const PixelBox& box, int longest_side);

}  // namespace vvr::video
