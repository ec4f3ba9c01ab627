#pragma once

#include <glm/glm.hpp>

#include "core/image/picture.h"

namespace vvr {

/// Draws a line with round ends over a picture, its edges smooth. Positions and width in pixels; the centre of the
/// first pixel is 0. A line that ends where it begins is a dot.
void draw_line(Picture& picture, const glm::dvec2& from, const glm::dvec2& to, double width, const Rgba& colour);

}  // namespace vvr
