#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/image/text.h"

namespace vvr::labels {

/// A line of text on a picture.
struct Label {
    std::string text;
    int size = 0;
    int x = 0;  ///< of the beginning of the baseline
    int y = 0;
    PixelBox box;  ///< of the letters
    image::Rgba colour{};
    std::optional<image::Rgba> halo{};  ///< around the letters, where they lie on something of any colour
};

/// A bar of colours, from left to right.
struct ColourBar {
    PixelBox box;
    std::vector<image::Rgba> colours;
};

/// A small picture with a border around it.
struct PastedPicture {
    PixelBox box;  ///< without its border
    Plane<Bgr> picture;
    image::Rgba colour{};  ///< of the border
    int border = 0;        ///< its width
};

/// A straight line with round ends; of no length, a dot.
struct Stroke {
    glm::dvec2 from{};
    glm::dvec2 to{};
    double width = 1;
    image::Rgba colour{};
};

/// A short text on a disc.
struct Badge {
    Label label;
    glm::dvec2 middle{};
    double size = 0;  ///< diameter
    image::Rgba colour{};
    PixelBox box;
};

/// A part of the picture that stands for an object: its portrait, its number, its bar.
struct Region {
    PixelBox box;
    std::size_t number = 0;  ///< of the object
};

/// What is written and drawn flat over a picture: pictures first, then bars, strokes, badges and texts. No text lies
/// over another text, a bar of the legend, a picture or a badge, and all are inside the picture.
struct Lettering {
    std::vector<PastedPicture> pictures;
    std::vector<ColourBar> bars;
    std::vector<Stroke> strokes;
    std::vector<Badge> badges;
    std::vector<Label> labels;
    std::vector<Region> regions;
    bool font_missing = false;  ///< text was asked for, and there is no font

    /// Whether nothing that may not be hidden is in a box.
    bool is_free(const PixelBox& box) const;

    /// Adds a label if its box is inside `area` and at least `gap` pixels from the others.
    /// \returns whether it was added
    bool add(const Label& label, const PixelBox& area, int gap);
};

/// A label whose baseline begins at `x`,`y`; without text if there is no font.
Label make_label(const std::string& text, int size, int x, int y, const image::Rgba& colour);

/// The same with the middle of its box at a point.
Label make_label_around(const std::string& text, int size, double x, double y, const image::Rgba& colour);

/// A badge with its middle at a point. Its text is white or black, whichever is easier to read on the colour.
Badge make_badge(const std::string& text, const glm::dvec2& middle, int size, const image::Rgba& colour);

/// Writes the first of several texts that fits: a label that begins at `x`,`y` and stays in `area`.
void add_first_that_fits(std::span<const std::string> texts, int size, int x, int y, const PixelBox& area,
                         const image::Rgba& colour, Lettering& lettering);

/// The text, shortened to at most `width` pixels, with "…" in place of its end.
std::string elide(const std::string& text, int size, int width);

void draw(image::Picture& picture, const Lettering& lettering);

}  // namespace vvr::labels
