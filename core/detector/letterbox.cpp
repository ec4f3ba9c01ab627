#include "core/detector/letterbox.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"

namespace vvr::detector {

namespace {

constexpr std::uint8_t padding = 114;  // as in training

int scaled(int side, double scale, int most) {
    return std::clamp(static_cast<int>(std::lround(side * scale)), 1, most);
}

}  // namespace

ImageView view_of(const Plane<Bgr>& image) {
    const auto stride = static_cast<std::size_t>(image.width()) * sizeof(Bgr);
    const auto* const first = reinterpret_cast<const std::uint8_t*>(image.pixels().data());
    return {{first, image.pixels().size_bytes()}, image.size(), stride, ChannelOrder::bgr};
}

Letterbox::Letterbox(Size image, Size input)
    : scale(std::min(static_cast<double>(input.width) / image.width, static_cast<double>(input.height) / image.height)),
      content{scaled(image.width, scale, input.width), scaled(image.height, scale, input.height)} {}

PixelBox Letterbox::to_image(const InputBox& box, Size image) const {
    const bool known = !std::isnan(box.left + box.top + box.right + box.bottom);
    if (!known) return {};
    const auto pixel = [this](double place, int most) {
        return static_cast<int>(std::lround(std::clamp(place / scale, 0.0, static_cast<double>(most))));
    };
    return {pixel(box.left, image.width), pixel(box.top, image.height), pixel(box.right, image.width),
            pixel(box.bottom, image.height)};
}

Plane<Bgr> letterboxed(const ImageView& image, Size input) {
    const Letterbox letterbox(image.size, input);
    Plane<Bgr> boxed(input, Bgr{padding, padding, padding});
    const cv::Mat whole(image.size.height, image.size.width, CV_8UC3, const_cast<std::uint8_t*>(image.bytes.data()),
                        image.stride);
    const cv::Size size(letterbox.content.width, letterbox.content.height);
    cv::Mat content = cv_view(boxed)(cv::Rect({0, 0}, size));
    cv::resize(whole, content, size, 0, 0, cv::INTER_LINEAR);  // as in training
    return boxed;
}

}  // namespace vvr::detector
