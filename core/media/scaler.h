#pragma once

#include <memory>

#include "core/base/plane.h"
#include "core/media/frame.h"

namespace vvr::media {

class FrameSource;

/// Converts decoded frames to the field size: upright, with square pixels, by area averaging.
///
/// Grey is full-range luma: limited ("tv") range is stretched from 16..235 to 0..255, so that grey-level thresholds
/// mean the same for every pixel format. Colour is made only on request.
///
/// Not thread-safe: it keeps buffers between frames, so use one per thread.
class Scaler {
  public:
    Scaler(Size field_size, bool colour);
    explicit Scaler(const FrameSource& source);
    ~Scaler();
    Scaler(const Scaler&) = delete;
    Scaler& operator=(const Scaler&) = delete;
    Scaler(Scaler&&) noexcept;
    Scaler& operator=(Scaler&&) noexcept;

    /// \throws Error not_video if the pixel format can't be converted
    Frame operator()(const DecodedFrame& decoded);

  private:
    struct Parts;

    Size size_;
    bool colour_;
    std::unique_ptr<Parts> parts_;
};

/// A part of a frame in full size: cut out of the decoded picture, turned upright, with square pixels. If the frame has
/// no decoded picture, or one no larger than the field, or it can't be converted, the part comes from the frame itself.
/// Thread-safe.
/// \param box within the frame, in field pixels
/// \param longest_side in pixels; a larger part is shrunk by area averaging
Plane<Bgr> crop_of(const Frame& frame, const PixelBox& box, int longest_side);

/// The field size for pictures of display size `shown`.
/// \param asked as SourceOptions::field_size
///
/// \throws Error usage if the size isn't positive, limit if it is too large
Size field_size_for(Size shown, Size asked);

}  // namespace vvr::media
