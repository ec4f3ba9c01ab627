#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/render/render_clip.h"
#include "core/scene/theme.h"
#include "core/scene/traceline.h"
#include "core/scene/transfer_file.h"
#include "gl/volume_slicer.h"

namespace vvr {

/// When a clip began.
struct StartTime {
    bool as_recorded = false;  ///< the container knows
    WallClock clock;
};

/// The clock that a clip's ruler shows.
/// \throws Error usage where the container is to know and doesn't
WallClock clock_of(const StartTime& start, const VideoInfo& info);

/// What the picture shows of the volume and the flow.
struct LookOptions {
    std::vector<std::string> show = standard_show();
    int keyframes = 0;
    std::string theme{themes().front().name};
    std::string background;  ///< "none", "#rrggbb"; empty = the theme's
    std::string title;
    StartTime start_time;
    std::string transfer;  ///< a name or a file; empty = the theme's
    std::string colour{volume_colours().front().name};
    std::string shading{volume_shadings().front().name};
    double opacity = 1;      ///< factor on the extinction
    double glyph_scale = 1;  ///< factor on the arrows' size
    TraceOptions traces;

    /// The colour that the theme or --background asks for, multiplied by its opacity.
    glm::vec4 background_colour() const;
    bool shows(const std::string& part) const;
    VolumeColour volume_colour() const;
    VolumeShading volume_shading() const;
};

void add_options(CLI::App& app, LookOptions& options);

}  // namespace vvr
