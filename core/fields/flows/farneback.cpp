#include <opencv2/video/tracking.hpp>

#include "core/fields/flows/opencv.h"

namespace vvr::fields {
namespace {

// The settings that OpenCV's documentation suggests for smooth motion of large objects.
class Farneback final : public OpenCvFlow {
    void estimate(const cv::Mat& here, const cv::Mat& next, cv::Mat& flow) const override {
        cv::calcOpticalFlowFarneback(here, next, flow, 0.5, 4, 15, 3, 7, 1.5, 0);
    }
};

}  // namespace

std::unique_ptr<FlowMethod> make_farneback(const FlowOptions&) {
    return std::make_unique<Farneback>();
}

}  // namespace vvr::fields
