#pragma once

#include <string>

#include "core/image/picture.h"

namespace vvr {

/// Writes a line of text over a picture, `x` its middle and `y` the line that letters stand on, in pixels.
/// \returns false where the system has no font for it, or OpenImageIO was built without fonts; nothing is written then
bool draw_caption(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

}  // namespace vvr
