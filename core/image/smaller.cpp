#include "core/image/smaller.h"

#include <algorithm>

#include <opencv2/imgproc.hpp>

namespace vvr {

Picture smaller(const Picture& picture, int side) {
    const Size size = picture.pixels.size();
    const int longest = std::max(size.width, size.height);
    if (longest <= side) return {picture.pixels, picture.encoding, {}};
    const auto scaled = [&](int length) { return std::max(1, (length * side + longest / 2) / longest); };
    Picture result{Plane<Rgba>({scaled(size.width), scaled(size.height)}), picture.encoding, {}};
    // OpenCV takes no const data, and writes none of it.
    auto* const from = const_cast<Rgba*>(picture.pixels.pixels().data());
    const cv::Mat source(size.height, size.width, CV_32FC4, from);
    cv::Mat target(result.pixels.height(), result.pixels.width(), CV_32FC4, result.pixels.pixels().data());
    cv::resize(source, target, target.size(), 0, 0, cv::INTER_AREA);
    return result;
}

}  // namespace vvr
