#include <opencv2/video/tracking.hpp>

#include "core/fields/flows/opencv.h"

namespace vvr::fields {
namespace {

// The method compares patches of 8×8 pixels at a quarter of the size.
constexpr int smallest_side = 48;

class Dis final : public OpenCvFlow {
    // One object per call: it has buffers, and calls come from several threads.
    void estimate(const cv::Mat& here, const cv::Mat& next, cv::Mat& flow) const override {
        if (std::min(here.cols, here.rows) < smallest_side) {
            const int right = std::max(0, smallest_side - here.cols);
            const int bottom = std::max(0, smallest_side - here.rows);
            cv::Mat large_here, large_next, large;
            cv::copyMakeBorder(here, large_here, 0, bottom, 0, right, cv::BORDER_REPLICATE);
            cv::copyMakeBorder(next, large_next, 0, bottom, 0, right, cv::BORDER_REPLICATE);
            estimate(large_here, large_next, large);
            flow = large(cv::Rect(0, 0, here.cols, here.rows)).clone();
            return;
        }
        cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_FAST)->calc(here, next, flow);
    }
};

}  // namespace

std::unique_ptr<FlowMethod> make_dis(const FlowOptions&) {
    return std::make_unique<Dis>();
}

}  // namespace vvr::fields
