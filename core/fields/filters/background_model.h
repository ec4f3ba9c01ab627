#pragma once

#include <utility>

#include <opencv2/core.hpp>
#include <opencv2/video/background_segm.hpp>

#include "core/base/cv_view.h"
#include "core/fields/filter.h"

namespace vvr::fields {

/// A filter with one of OpenCV's adaptive background models. Their shadow detection is off, because it marks shadows
/// with a third value.
class BackgroundModel final : public Filter {
  public:
    explicit BackgroundModel(cv::Ptr<cv::BackgroundSubtractor> model) : model_(std::move(model)) {}

    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        Plane<std::uint8_t> result(input.frame.grey.size());
        cv::Mat out = cv_view(result);
        // KNN uses the random numbers of the calling thread, and frames run on any thread.
        std::swap(cv::theRNG(), random_);
        model_->apply(input.smooth.colour.empty() ? cv_view(input.smooth.grey) : cv_view(input.smooth.colour), out);
        std::swap(cv::theRNG(), random_);
        return result;
    }

  private:
    cv::Ptr<cv::BackgroundSubtractor> model_;
    cv::RNG random_;
};

// History length of the models, frames: OpenCV's default.
constexpr int background_history = 500;

}  // namespace vvr::fields
