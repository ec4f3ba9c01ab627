#pragma once

#include <array>

#include <opencv2/core.hpp>

#include "core/base/cv_view.h"
#include "core/fields/flow.h"

namespace vvr::fields {

/// A flow method of OpenCV. The methods share all but one call.
class OpenCvFlow : public FlowMethod {
  public:
    int reach() const override { return 1; }
    int margin() const override { return 32; }

    FlowFrame prepare(const Plane<std::uint8_t>& grey) const override { return {grey, {}}; }

    // From this frame to the next; at the clip's end, from the previous frame to this one.
    Flow operator()(std::span<const FlowFrame* const> frames, const Rect& part) const override {
        const std::size_t first = frames[2] == frames[1] ? 0 : 1;
        const cv::Rect rect(part.x, part.y, part.size.width, part.size.height);
        cv::Mat both;
        estimate(cv_view(frames[first]->grey)(rect).clone(), cv_view(frames[first + 1]->grey)(rect).clone(), both);
        Flow flow{Plane<float>(part.size), Plane<float>(part.size)};
        std::array planes{cv_view(flow.u), cv_view(flow.v)};
        cv::split(both, planes.data());
        return flow;
    }

  protected:
    virtual void estimate(const cv::Mat& here, const cv::Mat& next, cv::Mat& flow) const = 0;
};

}  // namespace vvr::fields
