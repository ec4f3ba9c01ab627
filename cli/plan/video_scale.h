#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/tracking/event.h"

namespace vvr::app {

/// Converts pixels of the field to pixels of the video.
class VideoScale {
  public:
    VideoScale(Size field, Size video)
        : video_(video),
          x_(static_cast<double>(video.width) / field.width),
          y_(static_cast<double>(video.height) / field.height) {}

    glm::dvec2 operator()(const glm::dvec2& place) const {
        return {(place.x + 0.5) * x_ - 0.5, (place.y + 0.5) * y_ - 0.5};
    }

    PixelBox operator()(const PixelBox& box) const {
        return {static_cast<int>(std::floor(box.left * x_)), static_cast<int>(std::floor(box.top * y_)),
                std::min(video_.width, static_cast<int>(std::ceil(box.right * x_))),
                std::min(video_.height, static_cast<int>(std::ceil(box.bottom * y_)))};
    }

    double length(const std::vector<tracking::PathPoint>& path) const {
        double length = 0;
        for (std::size_t k = 1; k < path.size(); ++k) {
            length += glm::distance((*this)(path[k - 1].place), (*this)(path[k].place));
        }
        return length;
    }

  private:
    Size video_;
    double x_;
    double y_;
};

}  // namespace vvr::app
