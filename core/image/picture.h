#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::image {

/// Red, green, blue, alpha, 0..1, premultiplied.
using Rgba = glm::vec4;

/// A colour value of 0..1 as one of 0..255. Others are clamped; NaN becomes 0.
inline std::uint8_t to_byte(float value) {
    constexpr float to_nearest = 0.5F;  // std::lround takes five times as long
    return static_cast<std::uint8_t>(255 * std::min(std::max(0.F, value), 1.F) + to_nearest);  // std::clamp keeps NaN
}

/// What each pixel of a picture shows, as planes of the picture's size. Empty unless requested.
struct PixelData {
    Plane<float> depth;     ///< along the view direction, from the eye or from the plane where parallel rays start,
                            ///< in P-space units; NaN = nothing visible
    Plane<float> time;      ///< seconds of the clip; NaN = none
    Plane<float> frame;     ///< index in the clip; -1 = none
    Plane<float> object{};  ///< number of the event; 0 = none. Empty if objects have no colours

    bool empty() const { return frame.empty(); }
};

/// An sRGB picture for a file, top row first.
struct Picture {
    Plane<Rgba> pixels;
    PixelData pixel_data{};
};

/// Converts a rendered picture to a picture for a file.
Picture to_picture(Plane<Rgba> drawn);

/// Settings of a picture: names and values, in order. In a file, the names begin with `vvr:`.
using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Sets a value, and replaces an earlier value of that name.
void put(Metadata& settings, std::string_view name, const std::string& value);

/// The value of that name, or an empty string.
std::string value_of(const Metadata& settings, std::string_view name);

/// A plane of the pixel data and the name of its channel in a file.
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

/// Draws an antialiased line with round caps over a picture. Positions and width are in pixels; the centre of the first
/// pixel is 0,0. A line of zero length is a dot.
void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour);

/// Resizes a plane of bytes, BGR or RGBA floats: by area averaging to shrink, by interpolation to grow.
template <class T>
Plane<T> resized(const Plane<T>& plane, Size size);

/// The mipmap levels of a texture, without the picture itself, down to a single pixel. Each level has half the width
/// and height of the previous one, rounded down, by area averaging.
std::vector<Plane<std::uint8_t>> mip_levels(const Plane<std::uint8_t>& picture);
std::vector<Plane<Bgr>> mip_levels(const Plane<Bgr>& picture);

/// A palette of up to 256 colours for a picture.
class Palette {
  public:
    using Colour = std::array<std::uint8_t, 3>;  ///< red, green, blue

    /// Chooses the colours by median cut: it splits the box of colours with the largest error.
    explicit Palette(const Picture& picture);

    const std::vector<Colour>& colours() const { return colours_; }

    /// The index of the nearest colour.
    std::uint8_t nearest(const Rgba& pixel);

  private:
    std::vector<Colour> colours_;
    std::vector<int> known_;  ///< cached results of `nearest` by the colour's upper bits; -1 = none
};

}  // namespace vvr::image
