#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/plane.h"
#include "core/fields/options.h"

namespace vvr::fields {

/// Where to look, of the field's size: 255 inside `options.roi` and outside `options.mask`, 0 elsewhere. Empty when
/// everything is to be looked at.
///
/// Both options are either polygons, `x,y x,y x,y` with `;` between polygons, in pixels of the video as it is shown,
/// from its top left corner, and free to cross its edges; or a text file (`.txt`) of them, a polygon per line, in which
/// `#` begins a comment; or a picture, brought to the field's size, of which grey 128 and brighter belongs to it.
///
/// \throws Error usage for polygons that aren't, io or not_video for a file that can't be read
Plane<std::uint8_t> make_region(const FieldOptions& options, Size field, Size video);

/// Whether one of both options means polygons, well written or not; else it is the name of a file.
bool is_polygon_list(std::string_view text);

/// The polygons of one of both options as a list, also those of a text file; empty for a picture.
/// \throws Error as validate_region
std::string polygon_list(std::string_view setting, const std::string& text);

/// Checks a polygon list, and that of a text file; takes anything else for the name of a picture.
/// \throws Error usage naming `setting`, where the text is wrong, and what it must be; io for a file that can't be read
void validate_region(std::string_view setting, const std::string& text);

}  // namespace vvr::fields
