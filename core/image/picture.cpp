#include "core/image/picture.h"

namespace vvr {

Picture to_picture(Plane<Rgba> drawn) {
    return {std::move(drawn), Encoding::srgb, {}};
}

}  // namespace vvr
