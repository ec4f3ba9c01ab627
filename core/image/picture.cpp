#include "core/image/picture.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"

namespace vvr::image {

void put(Metadata& settings, std::string_view name, const std::string& value) {
    const auto known = std::ranges::find(settings, name, &Metadata::value_type::first);
    if (known == settings.end()) {
        settings.emplace_back(name, value);
    } else {
        known->second = value;
    }
}

std::string value_of(const Metadata& settings, std::string_view name) {
    const auto found = std::ranges::find(settings, name, &Metadata::value_type::first);
    return found == settings.end() ? "" : found->second;
}

Picture to_picture(Plane<Rgba> drawn) {
    return {std::move(drawn)};
}

void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour) {
    Plane<Rgba>& pixels = picture.pixels;
    const double reach = width / 2 + 1;
    const auto low = [reach](double a, double b) {
        return std::max(0, static_cast<int>(std::floor(std::min(a, b) - reach)));
    };
    const auto high = [reach](double a, double b, int side) {
        return std::min(side - 1, static_cast<int>(std::ceil(std::max(a, b) + reach)));
    };
    const glm::dvec2 along = to - from;
    const double squared = glm::dot(along, along);
    for (int j = low(from.y, to.y); j <= high(from.y, to.y, pixels.height()); ++j) {
        for (int i = low(from.x, to.x); i <= high(from.x, to.x, pixels.width()); ++i) {
            const glm::dvec2 point(i, j);
            const double at = squared > 0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0;
            const double cover = std::clamp(width / 2 + 0.5 - glm::distance(point, from + at * along), 0.0, 1.0);
            Rgba& pixel = pixels.at(i, j);
            const auto over = static_cast<float>(cover);
            pixel += over * (colour - pixel * colour.a);
        }
    }
}

}  // namespace vvr::image

template <>
struct vvr::CvType<vvr::image::Rgba> {
    static constexpr int value = CV_32FC4;
};

namespace vvr::image {

template <class T>
Plane<T> resized(const Plane<T>& plane, Size size) {
    if (plane.size() == size) return plane;
    auto result = Plane<T>::for_overwrite(size);
    cv::Mat to = cv_view(result);
    const bool smaller = size.width <= plane.width() && size.height <= plane.height();
    cv::resize(cv_view(plane), to, to.size(), 0, 0, smaller ? cv::INTER_AREA : cv::INTER_LINEAR);
    return result;
}

template Plane<std::uint8_t> resized(const Plane<std::uint8_t>&, Size);
template Plane<Bgr> resized(const Plane<Bgr>&, Size);
template Plane<Rgba> resized(const Plane<Rgba>&, Size);

namespace {

template <class T>
std::vector<Plane<T>> levels_of(const Plane<T>& picture) {
    std::vector<Plane<T>> levels;
    const Plane<T>* before = &picture;
    while (before->width() > 1 || before->height() > 1) {
        levels.push_back(resized(*before, {std::max(1, before->width() / 2), std::max(1, before->height() / 2)}));
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

}  // namespace vvr::image
