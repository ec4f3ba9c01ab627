#include "core/fields/filters/background_model.h"

namespace vvr::fields {

std::unique_ptr<Filter> make_mog2(const FieldOptions&) {
    constexpr double variances = 16;  // OpenCV's default
    return std::make_unique<BackgroundModel>(cv::createBackgroundSubtractorMOG2(background_history, variances, false));
}

}  // namespace vvr::fields
