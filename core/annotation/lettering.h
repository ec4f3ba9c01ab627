#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/image/text.h"

namespace vvr::annotation {

/// A line of text on a picture.
struct Label {
    std::string text;
    int size = 0;
    int x = 0;  ///< start of the baseline
    int y = 0;
    PixelBox box;  ///< bounding box of the letters
    image::Rgba colour{};
    std::optional<image::Rgba> halo{};  ///< outline of the letters, for text over a picture
};

/// A colour scale, from left to right.
struct ColourBar {
    PixelBox box;
    std::vector<image::Rgba> colours;
};

/// A small picture with a border around it.
struct PastedPicture {
    PixelBox box;  ///< without the border
    Plane<Bgr> picture;
    image::Rgba colour{};  ///< border colour
    int border = 0;        ///< border width in pixels
};

/// A straight line with round caps; of zero length, a dot.
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

/// Flat text and graphics over a picture, drawn in this order: pictures, bars, strokes, badges, texts. Everything is
/// inside the picture, and no text overlaps another text, a bar, a picture or a badge.
struct Lettering {
    std::vector<PastedPicture> pictures;
    std::vector<ColourBar> bars;
    std::vector<Stroke> strokes;
    std::vector<Badge> badges;
    std::vector<Label> labels;
    bool font_missing = false;  ///< text was requested, but there is no font

    /// The characters of its texts, in UTF-8, that no font has.
    std::set<std::string> missing_characters() const;

    /// Whether `box` intersects no label, bar, picture or badge.
    bool is_free(const PixelBox& box) const;

    /// Adds a label if it has text, its box is inside `area`, and it keeps `gap` pixels from everything else.
    /// \returns whether it was added
    bool add(const Label& label, const PixelBox& area, int gap);
};

/// A label whose baseline starts at `x`,`y`. Its text is empty if there is no font.
Label make_label(const std::string& text, int size, int x, int y, const image::Rgba& colour);

/// As `make_label`, with its box centred on a point.
Label make_centred_label(const std::string& text, int size, double x, double y, const image::Rgba& colour);

/// A badge centred on a point. Its text is white or black, whichever contrasts more.
Badge make_badge(const std::string& text, const glm::dvec2& middle, int size, const image::Rgba& colour);

/// Adds the first of `texts` that fits into `area`, with its baseline starting at `x`,`y`.
void add_first_that_fits(std::span<const std::string> texts, int size, int x, int y, const PixelBox& area,
                         const image::Rgba& colour, Lettering& lettering);

/// Shortens a text to `width` pixels: "…" replaces its end.
std::string elide(const std::string& text, int size, int width);

void draw(image::Picture& picture, const Lettering& lettering);

}  // namespace vvr::annotation
