#pragma once

#include <string>
#include <vector>

#include "core/image/text.h"

namespace vvr {

/// A line of text on a picture.
struct Label {
    std::string text;
    int size = 0;
    int x = 0;  ///< where the line that letters stand on begins
    int y = 0;
    PixelBox box;  ///< what the letters cover
    Rgba colour{};
};

/// A bar of colours, from left to right.
struct ColourBar {
    PixelBox box;
    std::vector<Rgba> colours;
};

/// What is written over a picture. No two of its boxes meet, and none leaves the picture.
struct Lettering {
    std::vector<Label> labels;
    std::vector<ColourBar> bars;
    bool font_missing = false;  ///< there would be text, and there is no font

    /// Adds a label if its box lies in `area` and leaves the others `gap` pixels.
    /// \returns whether it was added
    bool add(const Label& label, const PixelBox& area, int gap);
};

/// A label whose letters begin at `x` on the line `y`; no text where there is no font.
Label make_label(const std::string& text, int size, int x, int y, const Rgba& colour);

/// The same with the middle of its box at a point.
Label make_label_around(const std::string& text, int size, double x, double y, const Rgba& colour);

/// The text with as much of its end left out as makes it at most `width` pixels wide, "…" in its place.
std::string elide(const std::string& text, int size, int width);

void draw(Picture& picture, const Lettering& lettering);

}  // namespace vvr
