#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace vvr::scene {

/// The colours of all that isn't the video's.
struct Theme {
    std::string_view name;
    std::string_view help;
    glm::vec3 background;
    glm::vec3 ink;              ///< text that is to be read first
    glm::vec3 pale_ink;         ///< other text
    glm::vec3 lines;            ///< the volume's outline, the ruler's marks
    glm::vec4 shadow;           ///< on the floor
    std::string_view transfer;  ///< the transfer function that shows well on it
    glm::vec3 slow;             ///< arrows and tracelines
    glm::vec3 fast;
    std::array<glm::vec3, 8> objects;  ///< sRGB; all eyes tell them apart, and their greys differ too
    glm::vec3 unowned;                 ///< what belongs to no object
};

/// The themes; the first is the default.
std::span<const Theme> themes();

/// The colour (sRGB) of a hue in degrees: red lies near 30, green near 145, blue near 260. In OKLCH (Ottosson 2020), in
/// which hues of one lightness and chroma look alike strong. What a screen can't show is cut off.
/// \param lightness 0..1
/// \param chroma 0..0.3
glm::vec3 hue_colour(double lightness, double chroma, double degrees);

/// The colour of a direction in the picture, as a wheel has them.
/// \param direction to the right and down, of any length but 0
glm::vec3 direction_colour(const glm::dvec2& direction);

/// The colours of time, from the first moment to the last: each later one is lighter and of another hue.
std::vector<glm::vec4> time_colours();

/// How an object is while a voxel shows it.
enum class ObjectState {
    moving,
    still,   ///< it stands or lies, and is in a light stretch of its stripes
    marked,  ///< in a dark one
};

/// The place in `object_palette` of an object.
/// \param colour as `colours_of` gives it
std::uint8_t palette_index(int colour, ObjectState state);

/// The palette of objects, what is nobody's first: colour, and a factor on the extinction.
std::vector<glm::vec4> object_palette(const Theme& theme);

}  // namespace vvr::scene
