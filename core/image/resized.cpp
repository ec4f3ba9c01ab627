#include "core/image/resized.h"

#include <opencv2/imgproc.hpp>

#include "core/base/cv_view.h"
#include "core/image/picture.h"

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

}  // namespace vvr::image
