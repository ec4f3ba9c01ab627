#pragma once

#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "core/plane.h"

namespace vvr {

/// Red, green, blue, alpha, 0..1, colours multiplied by alpha.
using Rgba = glm::vec4;

/// How the values of a picture relate to light.
enum class Encoding {
    srgb,    ///< as a display wants them
    linear,  ///< proportional to light
};

/// What each pixel of a picture shows, of one size with it; empty where nobody asked.
struct PictureLayers {
    Plane<float> depth;  ///< along the view direction, from the eye or from the plane that parallel rays start on, in
                         ///< units of the layout's radii; NaN where nothing is seen
    Plane<float> time;   ///< seconds of the clip; NaN where nothing with a time is seen
    Plane<float> frame;  ///< index in the clip; -1 where nothing with a time is seen

    bool empty() const { return frame.empty(); }
};

/// A picture as it goes to a file or comes from one, top row first.
struct Picture {
    Plane<Rgba> pixels;
    Encoding encoding = Encoding::srgb;
    PictureLayers layers{};
};

/// A drawn picture as it goes to a file, its values as a display wants them.
Picture to_picture(Plane<Rgba> drawn);

/// Settings that stand in a picture file: name and value, in the order given. Names carry no prefix here,
/// `vvr:` in the file.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace vvr
