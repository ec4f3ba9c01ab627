#pragma once

#include <memory>
#include <optional>

#include <opencv2/core.hpp>

#include "core/video/frame.h"

struct SwsContext;

namespace vvr::video {

struct SwsFree {
    void operator()(SwsContext* context) const;
};

/// Scales planes of 8 bits: area averaging where the picture shrinks, linear where it grows, each way by itself.
/// What it returns is valid until its next call.
class AreaScaler {
  public:
    /// \param from rows with libav's padding behind them, one or two channels
    cv::Mat operator()(const cv::Mat& from, cv::Size to);

  private:
    cv::Mat shrink(const cv::Mat& from, cv::Size to);
    void prepare(cv::Size from, cv::Size to);

    std::optional<std::pair<cv::Size, cv::Size>> sizes_;
    std::unique_ptr<SwsContext, SwsFree> context_;
    AvFrame scaled_;
};

}  // namespace vvr::video
