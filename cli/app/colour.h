#pragma once

#include <string>
#include <vector>

#include "gl/render_options.h"

namespace vvr::app {

/// The name of the row whose colours say which way things move.
inline constexpr const char* colour_by_direction = "direction";

/// One row of the table of colours: where those of the volume come from. Its opacity is the transfer function's, of the
/// filter's values.
struct ColourRow {
    std::string name;
    std::string help;
    gl::VolumeColour drawn = gl::VolumeColour::transfer;
    bool needs_pictures = false;
    bool needs_flow = false;  ///< of each frame
    std::string filter{};     ///< a second filter, whose values have the colours; empty = none
};

/// The rows; the first leaves the choice open.
const std::vector<ColourRow>& colour_rows();

/// \throws Error usage when there is no such row
const ColourRow& find_colour(const std::string& name);

}  // namespace vvr::app
