#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/fields/options.h"
#include "core/plane.h"

namespace vvr {

/// Where to look, of the field's size: 255 inside `options.roi` and outside `options.mask`, 0 elsewhere. Empty when
/// everything is to be looked at.
///
/// Both options are either polygons, `x,y x,y x,y` with `;` between polygons, in pixels of the video as it is shown,
/// from its top left corner, and free to cross its edges; or a picture, brought to the field's size, of which what is
/// brighter than half belongs to it.
///
/// \throws Error usage for polygons that aren't, io or not_video for a picture that can't be read
Plane<std::uint8_t> make_region(const FieldOptions& options, Size field, Size video);

/// Whether one of both options means polygons, well written or not; else it is the name of a picture.
bool is_polygon_list(std::string_view text);

/// Checks a polygon list; takes anything else for the name of a picture.
/// \throws Error usage naming `setting`, where the text is wrong, and what it must be
void validate_region(std::string_view setting, const std::string& text);

}  // namespace vvr
