#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace vvr::scene {

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

}  // namespace vvr::scene
