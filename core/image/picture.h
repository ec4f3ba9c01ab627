#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::image {

/// Red, green, blue, alpha, 0..1, colours multiplied by alpha.
using Rgba = glm::vec4;

/// What each pixel of a picture shows, as planes of the picture's size; empty unless asked for.
struct PixelData {
    Plane<float> depth;  ///< along the view direction, from the eye or from the plane that parallel rays start on, in
                         ///< units of the layout's radii; NaN where there is nothing
    Plane<float> time;   ///< seconds of the clip; NaN where nothing has a time
    Plane<float> frame;  ///< index in the clip; -1 where nothing has a time
    Plane<float> object{};  ///< number of the event; 0 where there is none. Empty where objects have no colours

    bool empty() const { return frame.empty(); }
};

/// A picture in sRGB as it goes to a file or comes from one, top row first.
struct Picture {
    Plane<Rgba> pixels;
    PixelData pixel_data{};
};

/// A drawn picture as it goes to a file.
Picture to_picture(Plane<Rgba> drawn);

/// Settings of a picture: name and value, in the order given. In a file their names begin with `vvr:`.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Sets a value, in place of the one that has its name.
void put(Metadata& settings, std::string_view name, const std::string& value);

/// The value of that name; empty where there is none.
std::string value_of(const Metadata& settings, std::string_view name);

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

/// Draws a line with round ends and smooth edges over a picture. Positions and width are in pixels; the centre of the
/// first pixel is 0,0. A line of no length is a dot.
void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour);

/// A plane of bytes, of BGR or of RGBA floats at another size. Where it shrinks, each pixel is the mean of those that
/// it covers; where it grows, values are interpolated.
template <class T>
Plane<T> resized(const Plane<T>& plane, Size size);

/// The levels of a texture below the picture itself, down to a single pixel. Each has half the width and height of the
/// level before, rounded down, and each of its pixels is the mean of those that it covers there.
std::vector<Plane<std::uint8_t>> mip_levels(const Plane<std::uint8_t>& picture);
std::vector<Plane<Bgr>> mip_levels(const Plane<Bgr>& picture);

}  // namespace vvr::image
