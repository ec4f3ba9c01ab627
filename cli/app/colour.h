#pragma once

#include <string>
#include <vector>

#include "core/base/choice.h"
#include "core/fields/options.h"
#include "gl/render_options.h"

namespace vvr::app {

/// One row of the table of colours: where those of the volume come from. Its opacity is the transfer function's, of the
/// filter's values.
struct ColourRow {
    std::string name;
    std::string help;
    gl::VolumeColour drawn = gl::VolumeColour::transfer;
    bool needs_pictures = false;
    bool needs_flow = false;                    ///< of each frame
    bool of_direction = false;                  ///< of the flow, not its speed
    const fields::FilterRow* filter = nullptr;  ///< a second filter, whose values have the colours; null = none
};

/// The rows; the first leaves the choice open.
const std::vector<ColourRow>& colour_rows();

const ColourRow& row_of(Name<ColourRow> name);

}  // namespace vvr::app
