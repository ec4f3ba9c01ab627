#include "core/image/picture.h"

namespace vvr::image {

Picture to_picture(Plane<Rgba> drawn) {
    return {std::move(drawn), Encoding::srgb, {}};
}

}  // namespace vvr::image
