#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/image/picture.h"

namespace vvr::image {

/// Makes text printable on one line: replaces control characters by spaces, and bytes that are not UTF-8 by `?`.
std::string printable(const std::string& text);

/// The file name, without folders, of the font of text: fontconfig's sans serif font. Characters that it lacks
/// are drawn with other fonts. Empty if there is none.
std::string font_name();

/// The characters of a text, in UTF-8, that no font of this machine has. A picture shows an empty box for each.
std::set<std::string> missing_characters(const std::string& text);

/// The bounding box of a line of text whose baseline begins at 0,0, in pixels.
/// \param size font size, pixels
/// \returns empty if there is no font
std::optional<PixelBox> measure_text(const std::string& text, int size);

/// Draws a line of text over a picture. Its baseline begins at `x`,`y`, in pixels.
/// \returns false if there is no font, and then draws nothing
bool draw_text(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

/// The same, with the text centred at `x`.
bool draw_text_centred(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

/// The files and folders that fontconfig reads, including its caches. Some may not exist.
std::vector<std::filesystem::path> font_places();

}  // namespace vvr::image
