#pragma once

#include <array>
#include <string_view>

#include "core/image/picture.h"

namespace vvr {

/// One of a picture's layers, and the channel of a file that holds it.
struct LayerChannel {
    std::string_view name;
    Plane<float> PictureLayers::*plane;
};

inline constexpr std::array layer_channels{
    LayerChannel{"Z", &PictureLayers::depth},
    LayerChannel{"time", &PictureLayers::time},
    LayerChannel{"frame", &PictureLayers::frame},
};

}  // namespace vvr
