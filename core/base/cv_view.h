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

/// A cv::Mat that shares the plane's pixels: valid as long as the plane is. Never write through a view of a const
/// plane; cv::Mat can't express constness.
template <class T>
cv::Mat cv_view(const Plane<T>& plane) {
    return {plane.height(), plane.width(), CvType<T>::value, const_cast<T*>(plane.pixels().data())};
}

}  // namespace vvr
