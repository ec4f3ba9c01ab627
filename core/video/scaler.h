#pragma once

#include <memory>

#include "core/video/frame.h"

namespace vvr::video {

class FrameSource;

/// Turns decoded frames upright, to square pixels, and to the field size, by area averaging.
///
/// Grey is luma in full range: limited ("tv") luma is stretched from 16..235 to 0..255, so that a threshold in grey
/// levels means the same for every pixel format. Colour is made only when asked for.
///
/// Each thread needs its own: it holds buffers between frames.
class Scaler {
  public:
    Scaler(Size field_size, bool colour);
    explicit Scaler(const FrameSource& source);
    ~Scaler();
    Scaler(const Scaler&) = delete;
    Scaler& operator=(const Scaler&) = delete;
    Scaler(Scaler&&) noexcept;
    Scaler& operator=(Scaler&&) noexcept;

    /// \throws Error not_video for a pixel format that can't be converted
    Frame operator()(const DecodedFrame& decoded);

  private:
    struct Parts;

    Size size_;
    bool colour_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace vvr::video
