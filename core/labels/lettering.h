#pragma once

#include <string>
#include <vector>

#include "core/image/text.h"

namespace vvr {

/// A line of text on a picture.
struct Label {
    std::string text;
    int size = 0;
    int x = 0;  ///< of the beginning of the baseline
    int y = 0;
    PixelBox box;  ///< of the letters
    Rgba colour{};
};

/// A bar of colours, from left to right.
struct ColourBar {
    PixelBox box;
    std::vector<Rgba> colours;
};

/// Texts and bars to draw over a picture. No two of their boxes overlap, and all are inside the picture.
struct Lettering {
    std::vector<Label> labels;
    std::vector<ColourBar> bars;
    bool font_missing = false;  ///< text was asked for, and there is no font

    /// Adds a label if its box is inside `area` and at least `gap` pixels from the others.
    /// \returns whether it was added
    bool add(const Label& label, const PixelBox& area, int gap);
};

/// A label whose baseline begins at `x`,`y`; without text if there is no font.
Label make_label(const std::string& text, int size, int x, int y, const Rgba& colour);

/// The same with the middle of its box at a point.
Label make_label_around(const std::string& text, int size, double x, double y, const Rgba& colour);

/// The text, shortened to at most `width` pixels, with "…" in place of its end.
std::string elide(const std::string& text, int size, int width);

void draw(Picture& picture, const Lettering& lettering);

}  // namespace vvr
