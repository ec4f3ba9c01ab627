#pragma once

#include <glm/glm.hpp>

#include "core/image/picture.h"

namespace vvr::image {

/// Draws a line with round ends and smooth edges over a picture. Positions and width are in pixels; the centre of the
/// first pixel is 0,0. A line of no length is a dot.
void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour);

}  // namespace vvr::image
