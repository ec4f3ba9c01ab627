#pragma once

#include <array>
#include <string_view>

#include "core/image/picture.h"

namespace vvr::image {

/// One plane of a picture's pixel data, and the channel of a file that holds it.
struct PixelDataChannel {
    std::string_view name;
    Plane<float> PixelData::*plane;
};

inline constexpr std::array pixel_data_channels{
    PixelDataChannel{"Z", &PixelData::depth},
    PixelDataChannel{"time", &PixelData::time},
    PixelDataChannel{"frame", &PixelData::frame},
    PixelDataChannel{"object", &PixelData::object},
};

}  // namespace vvr::image
