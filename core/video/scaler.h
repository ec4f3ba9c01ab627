#pragma once

#include <memory>
#include <optional>
#include <utility>

#include <opencv2/core.hpp>

#include "core/video/frame.h"

struct SwsContext;

namespace vvr::video {

class FrameSource;

struct SwsFree {
    void operator()(SwsContext* context) const;
};

/// Scales 8-bit planes. Each axis is scaled separately: by area averaging to shrink, by linear interpolation to grow.
/// The result is valid until the next call.
class AreaScaler {
  public:
    /// \param from one or two channels; rows need libav's padding
    cv::Mat operator()(const cv::Mat& from, cv::Size to);

  private:
    cv::Mat shrink(const cv::Mat& from, cv::Size to);
    void prepare(cv::Size from, cv::Size to);

    std::optional<std::pair<cv::Size, cv::Size>> sizes_;
    std::unique_ptr<SwsContext, SwsFree> context_;
    AvFrame scaled_;
};

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
