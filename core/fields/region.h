#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/plane.h"
#include "core/fields/options.h"

namespace vvr::fields {

/// Whether the options leave a part of the picture out.
bool has_region(const FieldOptions& options);

/// The region of interest, in the field's size: 255 inside `options.roi` and outside `options.mask` and
/// `options.overlays`, 0 elsewhere. Empty if nothing is ignored.
///
/// The region and the mask are one of three each. Polygons, `x,y x,y x,y` with `;` between polygons, in pixels of the
/// displayed video from its top left corner; they may cross its edges. A text file (`.txt`), one polygon per line, in
/// which `#` begins a comment. A picture, scaled to the field's size, of which grey levels from 128 on belong to the
/// area.
///
/// \throws Error usage for invalid polygons, io or not_video for a file that can't be read
Plane<std::uint8_t> make_region(const FieldOptions& options, Size field, Size video);

/// Whether an option's text is meant as polygons, valid or not; else it is a file's name.
bool is_polygon_list(std::string_view text);

/// An option's polygons as one list, also those of a text file; empty for a picture.
/// \throws Error as validate_region
std::string polygon_list(std::string_view setting, const std::string& text);

/// Checks the polygons of an option's text or text file. Any other text is taken as a picture's name.
/// \throws Error usage with `setting`, the error's position and the format; io for a file that can't be read
void validate_region(std::string_view setting, const std::string& text);

}  // namespace vvr::fields
