#include <algorithm>
#include <array>

#include <opencv2/core.hpp>
#include <opencv2/video/tracking.hpp>

#include "core/base/cv_view.h"
#include "core/fields/flow.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

/// A flow method of OpenCV. The methods share all but one call.
class OpenCvFlow : public FlowMethod {
  public:
    int reach() const override { return 1; }
    int margin() const override { return 32; }

    FlowFrame prepare(const Plane<std::uint8_t>& grey) const override { return {grey, {}}; }

    // From this frame to the next; at the clip's end, from the previous frame to this one.
    Flow operator()(std::span<const FlowFrame* const> frames, const PixelBox& part) const override {
        const std::size_t first = frames[2] == frames[1] ? 0 : 1;
        const cv::Rect rect(part.left, part.top, part.width(), part.height());
        cv::Mat both;
        estimate(cv_view(frames[first]->grey)(rect).clone(), cv_view(frames[first + 1]->grey)(rect).clone(), both);
        Flow flow{Plane<float>(part.size()), Plane<float>(part.size())};
        std::array planes{cv_view(flow.u), cv_view(flow.v)};
        cv::split(both, planes.data());
        return flow;
    }

  protected:
    virtual void estimate(const cv::Mat& here, const cv::Mat& next, cv::Mat& flow) const = 0;
};

class Dis final : public OpenCvFlow {
    // One object per call: it has buffers, and calls come from several threads.
    void estimate(const cv::Mat& here, const cv::Mat& next, cv::Mat& flow) const override {
        if (std::min(here.cols, here.rows) < thresholds.flow.smallest_dis) {
            const int right = std::max(0, thresholds.flow.smallest_dis - here.cols);
            const int bottom = std::max(0, thresholds.flow.smallest_dis - here.rows);
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

// The settings that OpenCV's documentation suggests for smooth motion of large objects.
class Farneback final : public OpenCvFlow {
    void estimate(const cv::Mat& here, const cv::Mat& next, cv::Mat& flow) const override {
        cv::calcOpticalFlowFarneback(here, next, flow, 0.5, 4, 15, 3, 7, 1.5, 0);
    }
};

}  // namespace

std::unique_ptr<FlowMethod> make_dis(const FlowOptions&) {
    return std::make_unique<Dis>();
}

std::unique_ptr<FlowMethod> make_farneback(const FlowOptions&) {
    return std::make_unique<Farneback>();
}

}  // namespace vvr::fields
