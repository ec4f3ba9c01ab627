#pragma once

#include <string>
#include <vector>

#include "core/labels/lettering.h"
#include "core/labels/sheet.h"

namespace vvr::labels {

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
