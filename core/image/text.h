#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/image/picture.h"

namespace vvr::image {

/// Text for one line: a space for each control character, `?` for each byte that is not UTF-8.
std::string printable(const std::string& text);

/// \throws Error io for a file that FreeType can't read letters of
void check_font(const std::filesystem::path& file);

/// Has all text from now on drawn with the letters of a font file; of fontconfig's sans serif font if it is empty. A
/// process has one font: nearly all functions that lay out text measure it.
/// \throws Error io as check_font
void choose_font(const std::filesystem::path& file);

/// The name of the font's file, without folders; empty where there is none.
std::string font_name();

/// The box of a line of text whose baseline begins at 0,0.
/// \returns nothing if fontconfig finds no font
std::optional<PixelBox> measure_text(const std::string& text, int size);

/// Draws a line of text over a picture, its baseline from `x`,`y` on, in pixels.
/// \returns false if there is no font; nothing is drawn then
bool draw_text(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

/// The same with the text's middle at `x`.
bool draw_text_centred(Picture& picture, int x, int y, const std::string& text, int size, const Rgba& colour);

/// The files and folders that fontconfig reads to find a font, its caches among them. Some may not be there.
std::vector<std::filesystem::path> font_places();

}  // namespace vvr::image
