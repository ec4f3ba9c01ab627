#include "core/fields/planes.h"

#include <array>
#include <cstddef>

#include <opencv2/core.hpp>

#include "core/base/cv_view.h"
#include "core/kernels/byte_blur.h"

namespace vvr::fields {
namespace {

template <class T>
Plane<T> smooth_plane(const Plane<T>& plane, double sigma) {
    if (plane.empty() || sigma <= 0) return plane;
    auto result = Plane<T>::for_overwrite(plane.size());
    const std::size_t count = plane.pixels().size_bytes();
    kernels::blur_bytes(plane.size(), sizeof(T), sigma,
                        {reinterpret_cast<const std::uint8_t*>(plane.pixels().data()), count},
                        {reinterpret_cast<std::uint8_t*>(result.pixels().data()), count});
    return result;
}

}  // namespace

Planes smoothed(const Plane<std::uint8_t>& grey, const Plane<Bgr>& colour, double sigma) {
    return {smooth_plane(grey, sigma), smooth_plane(colour, sigma)};
}

Plane<std::uint8_t> largest_difference(const Planes& a, const Planes& b) {
    auto result = Plane<std::uint8_t>::for_overwrite(a.grey.size());
    if (a.colour.empty() || b.colour.empty()) {
        cv::absdiff(cv_view(a.grey), cv_view(b.grey), cv_view(result));
        return result;
    }
    cv::Mat difference;
    cv::absdiff(cv_view(a.colour), cv_view(b.colour), difference);
    std::array<cv::Mat, 3> channels;
    cv::split(difference, channels.data());
    cv::max(channels[0], channels[1], channels[0]);
    cv::Mat largest = cv_view(result);
    cv::max(channels[0], channels[2], largest);
    return result;
}

}  // namespace vvr::fields
