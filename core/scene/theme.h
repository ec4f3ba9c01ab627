#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::scene {

/// The colours of everything except the video.
struct Theme {
    std::string_view name;
    std::string_view help;
    glm::vec3 background;
    glm::vec3 ink;              ///< primary text
    glm::vec3 pale_ink;         ///< secondary text
    glm::vec3 lines;            ///< the volume's outline, the ruler's marks
    glm::vec4 shadow;           ///< on the floor
    std::string_view transfer;  ///< default transfer function
    glm::vec3 slow;             ///< arrows and tracelines
    glm::vec3 fast;
    std::array<glm::vec3, 8> objects;  ///< sRGB; distinct with colour blindness and in greyscale
    glm::vec3 unowned;                 ///< motion that belongs to no object
};

/// The first row is the default.
std::span<const Theme> themes();

/// Converts OKLCH (Ottosson 2020), whose hues of equal lightness and chroma look equally strong, to sRGB. Clips to the
/// sRGB gamut.
/// \param lightness 0..1
/// \param chroma 0..0.3
/// \param degrees hue: red is near 30, green near 145, blue near 260
glm::vec3 hue_colour(double lightness, double chroma, double degrees);

/// The colour (sRGB) of a direction on the colour wheel.
/// \param direction x to the right, y down; any length but 0
glm::vec3 direction_colour(const glm::dvec2& direction);

/// A colour as 8-bit BGR, clipped to 0..1.
Bgr bgr_of(const glm::vec3& colour);

/// The colours of time, first to last, sRGB: 256 of increasing lightness and changing hue.
std::vector<glm::vec4> time_colours();

/// The state of an object at a voxel.
enum class ObjectState {
    moving,
    still,   ///< stationary, in a light stripe
    marked,  ///< stationary, in a dark stripe
};

/// The index of an object in `object_palette`.
/// \param colour as returned by `colours_of`
std::uint8_t palette_index(int colour, ObjectState state);

/// The state of which `palette_index` made an index. An index without an object counts as moving.
ObjectState state_of(std::uint8_t index);

/// The palette of objects: colour, and a factor on the extinction. The first entry is for motion without an object.
std::vector<glm::vec4> object_palette(const Theme& theme);

}  // namespace vvr::scene
