#pragma once

#include <string>

#include "core/base/plane.h"

namespace vvr::page {

/// What a page shows on which regions are drawn.
struct RegionEditorContent {
    std::string name;    ///< of the clip, for people
    std::string moment;  ///< of the frame, for people
    Plane<Bgr> frame;    ///< at the size of the clip's picture, whose pixels are the unit of regions
    std::string roi;     ///< polygons to begin with, as in FieldOptions; empty = none
    std::string mask;    ///< the same of where not to look; of the two only one is edited, `roi` if there is one
};

/// A page that needs only a browser, and no other file: regions are drawn on the frame, and it gives the option for
/// them. Same content, same text.
std::string make_region_editor(const RegionEditorContent& content);

}  // namespace vvr::page
