#pragma once

#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::image {

/// Red, green, blue, alpha, 0..1, colours multiplied by alpha.
using Rgba = glm::vec4;

/// How the values of a picture relate to light.
enum class Encoding {
    srgb,    ///< as a display wants them
    linear,  ///< proportional to light
};

/// What each pixel of a picture shows, as planes of the picture's size; empty unless asked for.
struct PixelData {
    Plane<float> depth;  ///< along the view direction, from the eye or from the plane that parallel rays start on, in
                         ///< units of the layout's radii; NaN where there is nothing
    Plane<float> time;   ///< seconds of the clip; NaN where nothing has a time
    Plane<float> frame;  ///< index in the clip; -1 where nothing has a time
    Plane<float> object{};  ///< number of the event; 0 where there is none. Empty where objects have no colours

    bool empty() const { return frame.empty(); }
};

/// A picture as it goes to a file or comes from one, top row first.
struct Picture {
    Plane<Rgba> pixels;
    Encoding encoding = Encoding::srgb;
    PixelData pixel_data{};
};

/// A drawn picture as it goes to a file, its values as a display wants them.
Picture to_picture(Plane<Rgba> drawn);

/// Settings of a picture: name and value, in the order given. In a file their names begin with `vvr:`.
using Metadata = std::vector<std::pair<std::string, std::string>>;

}  // namespace vvr::image
