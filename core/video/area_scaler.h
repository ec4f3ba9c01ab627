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

}  // namespace vvr::video
