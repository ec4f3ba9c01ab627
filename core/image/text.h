#pragma once

#include <optional>
#include <string>

#include "core/image/picture.h"
#include "core/pixel_box.h"

namespace vvr {

/// Text as a line can show it: one space for control characters, `?` for what isn't UTF-8.
std::string printable(const std::string& text);

/// What a line of text covers when the line that letters stand on begins at 0,0.
/// \returns nothing where fontconfig finds no font
std::optional<PixelBox> measure_text(const std::string& text, int size);

/// Writes a line of text over a picture, from `x` on, `y` the line that letters stand on, in pixels.
/// \returns false where there is no font for it; nothing is written then
bool draw_text(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

/// The same with `x` its middle.
bool draw_text_centred(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

}  // namespace vvr
