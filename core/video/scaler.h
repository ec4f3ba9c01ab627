#pragma once

#include <memory>

#include "core/video/frame.h"

namespace vvr::video {

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

}  // namespace vvr::video
