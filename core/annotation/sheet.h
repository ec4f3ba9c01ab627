#pragma once

#include <string>
#include <vector>

#include "core/annotation/lettering.h"
#include "core/base/plane.h"
#include "core/image/text.h"

namespace vvr::annotation {

/// The parts of a picture besides the volume that need room.
struct SheetParts {
    bool title = false;
    bool ruler = false;
    bool legend = false;
    bool explanation = false;
    bool portraits = false;
    bool ends = false;    ///< first and last frame
    bool stills = false;  ///< between these, if the picture is tall enough
    bool strip = false;
    bool large_captions = false;  ///< above portraits: for a picture that is shown smaller than it is
};

/// Layout of a picture. From the top: title and legend, explanation, portraits, volume. At the bottom: the first frame
/// on the left, the last on the right, the time strip between them. In a tall picture there are stills between the
/// frames, and the time strip is below them.
struct Sheet {
    Size picture;
    int text = 0;    ///< text size in pixels; 0 = the picture is too small for text
    int small = 0;   ///< smaller text size in pixels
    int edge = 0;    ///< margin at the picture's borders in pixels
    PixelBox title;  ///< bands; empty if not shown
    PixelBox explanation;
    PixelBox portraits;
    int captions = 0;              ///< height of the portraits' text, in the upper part of `portraits`
    PixelBox first;                ///< the first frame
    PixelBox last;                 ///< the last frame
    std::vector<PixelBox> stills;  ///< between these, of the same size
    PixelBox strip;
    PixelBox legend;    ///< the title's band if they share it; then it doesn't overlap the title
    PixelBox map_area;  ///< where the map may be: above the strip, below the ruler's labels
    PixelBox between;   ///< the remaining area, for the ruler's labels
    PixelBox volume;    ///< the area that the camera fits the volume into
};

/// \param aspect a frame's width divided by its height
Sheet arrange_sheet(Size picture, const SheetParts& parts, double aspect = 4.0 / 3);

/// An entry of the legend: a colour scale and its meaning.
struct LegendEntry {
    std::vector<image::Rgba> colours;  ///< from left to right; empty = text only
    std::string text;                  ///< beside the colours
    std::string brief;                 ///< short text, for lack of room
    bool wheel = false;                ///< the colours are directions: rightwards first, then counterclockwise
};

/// Writes the entries into the sheet's legend, either all long or all brief. Drops the last entries that don't fit.
void label_legend(const std::vector<LegendEntry>& entries, const Sheet& sheet, const image::Rgba& colour,
                  Lettering& lettering);

/// Width of a brief legend with the space before it, in pixels.
int brief_width(const std::vector<LegendEntry>& entries, const Sheet& sheet);

/// Writes a title, and `rest` beside it in the colour `pale`. Elides what doesn't fit.
/// \param right the title ends there at the latest
void label_title(const std::string& title, const std::string& rest, int right, const Sheet& sheet,
                 const image::Rgba& colour, const image::Rgba& pale, Lettering& lettering);

}  // namespace vvr::annotation
