#pragma once

#include <string>
#include <vector>

#include "core/base/setting.h"
#include "core/fields/options.h"
#include "gl/render_options.h"

namespace vvr::app {

/// A row of the table of colours: the source of the volume's colours. The opacity always comes from the transfer
/// function of the filter's values.
struct ColourRow {
    std::string name;
    std::string help;
    gl::VolumeColour drawn = gl::VolumeColour::transfer;
    bool needs_pictures = false;
    bool needs_flow = false;                    ///< of each frame
    bool of_direction = false;                  ///< the colour shows the flow's direction, not its speed
    const fields::FilterRow* filter = nullptr;  ///< a second filter that provides the values to colour; null = none
};

/// The rows of the table. The first one leaves the choice to vvr.
const std::vector<ColourRow>& colour_rows();

const ColourRow& row_of(Name<ColourRow> name);

}  // namespace vvr::app
