#include "core/image/mip_levels.h"

#include <algorithm>

#include "core/image/resized.h"

namespace vvr::image {
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
