#include "core/fields/filters/background_model.h"

namespace vvr::fields {

std::unique_ptr<Filter> make_knn(const FieldOptions&) {
    constexpr double squared_distance = 400;  // OpenCV's default
    return std::make_unique<BackgroundModel>(
        cv::createBackgroundSubtractorKNN(background_history, squared_distance, false));
}

}  // namespace vvr::fields
