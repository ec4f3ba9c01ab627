#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

// Sobel masks give four times the height of a step; a quarter of that maps black beside white to 255.
class Edges final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        cv::Mat x, y, length;
        const cv::Mat grey = cv_view(input.smooth.grey);
        cv::Sobel(grey, x, CV_32F, 1, 0, 3, 0.25, 0, cv::BORDER_REPLICATE);
        cv::Sobel(grey, y, CV_32F, 0, 1, 3, 0.25, 0, cv::BORDER_REPLICATE);
        cv::magnitude(x, y, length);
        Plane<std::uint8_t> result(input.smooth.grey.size());
        cv::Mat out = cv_view(result);
        length.convertTo(out, CV_8U);
        return result;
    }
};

}  // namespace

std::unique_ptr<Filter> make_edges(const FieldOptions&) {
    return std::make_unique<Edges>();
}

}  // namespace vvr::fields
