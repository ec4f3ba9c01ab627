#include "core/image/mip_levels.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "core/cv_view.h"

namespace vvr {
namespace {

template <class T>
std::vector<Plane<T>> levels_of(const Plane<T>& picture) {
    std::vector<Plane<T>> levels;
    const Plane<T>* before = &picture;
    while (before->width() > 1 || before->height() > 1) {
        auto level = Plane<T>::for_overwrite({std::max(1, before->width() / 2), std::max(1, before->height() / 2)});
        cv::Mat out = cv_view(level);
        cv::resize(cv_view(*before), out, out.size(), 0, 0, cv::INTER_AREA);
        levels.push_back(std::move(level));
        before = &levels.back();
    }
    return levels;
}

}  // namespace

std::vector<Plane<std::uint8_t>> mip_levels(const Plane<std::uint8_t>& picture) {
    return levels_of(picture);
}

std::vector<Plane<Bgr>> mip_levels(const Plane<Bgr>& picture) {
    return levels_of(picture);
}

}  // namespace vvr
