#pragma once

#include <cstdint>

#include <opencv2/core.hpp>

#include "core/base/plane.h"

namespace vvr {

template <class T>
struct CvType;
template <>
struct CvType<std::uint8_t> {
    static constexpr int value = CV_8UC1;
};
template <>
struct CvType<Bgr> {
    static constexpr int value = CV_8UC3;
};
template <>
struct CvType<float> {
    static constexpr int value = CV_32FC1;
};

/// A plane's pixels as OpenCV sees them, not copied: valid as long as the plane is. A view of a const plane must
/// not be written to; OpenCV's type has no way to say so.
template <class T>
cv::Mat cv_view(const Plane<T>& plane) {
    return {plane.height(), plane.width(), CvType<T>::value, const_cast<T*>(plane.pixels().data())};
}

}  // namespace vvr
