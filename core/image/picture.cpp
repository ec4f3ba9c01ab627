#include "core/image/picture.h"

#include <algorithm>

namespace vvr {

Picture to_picture(const Plane<glm::vec4>& drawn) {
    Picture picture{Plane<Rgba>(drawn.size()), Encoding::srgb};
    std::ranges::transform(drawn.pixels(), picture.pixels.pixels().begin(), [](const glm::vec4& p) {
        return Rgba{p.x, p.y, p.z, p.w};
    });
    return picture;
}

}  // namespace vvr
