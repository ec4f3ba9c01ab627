#pragma once

#include <string>
#include <vector>

#include "core/base/plane.h"
#include "core/image/text.h"
#include "core/labels/lettering.h"

namespace vvr::labels {

/// Which parts of a picture beside the volume need room.
struct SheetParts {
    bool title = false;
    bool ruler = false;
    bool legend = false;
    bool explanation = false;
    bool portraits = false;
    bool ends = false;
    bool strip = false;
};

/// Where things lie on a picture, from the top down: title and legend, explanation, portraits, the volume; at the
/// bottom the first frame on the left, the last on the right, and between them the strip of times.
struct Sheet {
    Size picture;
    int text = 0;    ///< size of the text in pixels; 0 = the picture is too small for any
    int small = 0;   ///< size of the smaller text
    int edge = 0;    ///< pixels that stay free at the picture's borders
    PixelBox title;  ///< the bands; empty where there is none
    PixelBox explanation;
    PixelBox portraits;
    PixelBox first;  ///< the first frame
    PixelBox last;   ///< the last frame
    PixelBox strip;
    PixelBox legend;   ///< that of the title where both are shown; then it keeps clear of the title
    PixelBox hollow;   ///< in which the map may be: down to the strip, below what labels of the ruler may use
    PixelBox between;  ///< what is left: labels of the ruler stay in it
    PixelBox volume;   ///< the part of the picture that the camera's own picture fills
};

/// \param aspect width of a frame by its height
Sheet arrange_sheet(Size picture, const SheetParts& parts, double aspect = 4.0 / 3);

/// What a scale of colours means.
struct LegendEntry {
    std::vector<image::Rgba> colours;  ///< from left to right; none = only the text
    std::string text;                  ///< beside it
    std::string brief;                 ///< where there isn't room for that
    bool wheel = false;                ///< the colours are those of directions: to the right, then against the clock
};

/// Writes the entries into the sheet's legend, all with their whole text or all brief; the last are left out where
/// there isn't room even then.
void label_legend(const std::vector<LegendEntry>& entries, const Sheet& sheet, const image::Rgba& colour,
                  Lettering& lettering);

/// The width of a legend of brief texts, and of the space before it.
int brief_width(const std::vector<LegendEntry>& entries, const Sheet& sheet);

/// Writes a title, whose name ends at `right` at most, and beside it in another colour what there is to say of
/// it, into the sheet's title. What doesn't fit is left out from the end.
void label_title(const std::string& title, const std::string& rest, int right, const Sheet& sheet,
                 const image::Rgba& colour, const image::Rgba& pale, Lettering& lettering);

}  // namespace vvr::labels
