#include "core/video/frame.h"

#include <algorithm>

namespace vvr::video {

Plane<Bgr> picture_of(const Frame& frame) {
    if (!frame.colour.empty()) return frame.colour;
    Plane<Bgr> picture(frame.grey.size());
    std::ranges::transform(frame.grey.pixels(), picture.pixels().begin(), [](std::uint8_t grey) {
        return Bgr{grey, grey, grey};
    });
    return picture;
}

}  // namespace vvr::video
