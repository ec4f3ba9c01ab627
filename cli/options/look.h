#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/work/render_clip.h"
#include "core/scene/theme.h"
#include "core/scene/traceline.h"
#include "core/scene/transfer_file.h"
#include "gl/volume_slicer.h"

namespace vvr {

/// What the picture shows of the volume and the flow.
struct LookOptions {
    std::vector<std::string> show = standard_show();
    int keyframes = 0;
    std::string theme{themes().front().name};
    std::string background;  ///< "none", "#rrggbb"; empty = the theme's
    std::string title;
    WallClock clock;
    std::string transfer;  ///< a name or a file; empty = the theme's
    std::string colour{volume_colours().front().name};
    double opacity = 1;      ///< factor on the extinction
    double glyph_scale = 1;  ///< factor on the arrows' size
    TraceOptions traces;

    /// The colour that the theme or --background asks for, multiplied by its opacity.
    glm::vec4 background_colour() const;
    bool shows(const std::string& part) const;
    VolumeColour volume_colour() const;
};

void add_options(CLI::App& app, LookOptions& options);

}  // namespace vvr
