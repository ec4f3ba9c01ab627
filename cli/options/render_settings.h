#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "cli/render/render_clip.h"
#include "cli/options/bricks.h"
#include "cli/options/fields.h"
#include "cli/options/input.h"
#include "cli/options/look.h"
#include "cli/options/run.h"
#include "cli/options/view.h"

namespace vvr {

/// Every option that says how a picture comes about: `render` makes it, `info` only says what it would take.
struct RenderSettings {
    InputOptions input;
    FieldOptions fields;
    BrickOptions bricks;
    ViewOptions view;
    LookOptions look;
    BackendOptions backend;
    RunOptions run;
    std::string preset;  ///< whose options stand before the others
    std::string seeds;   ///< a folder of lists that replace the computed seeds; empty = none
};

/// Adds all the groups of options.
void add_options(CLI::App& app, RenderSettings& settings);

/// What no single option can know: an input is there, times are in order.
/// \param series a window slides over the clip
/// \throws Error usage
void check(const RenderSettings& settings, bool series = false);

/// Whether the fields or the picture want the frames in colour.
bool wants_colour(const RenderSettings& settings);

/// The job for a clip. Its source options only serve estimates, where the frame numbers that the user may have
/// given count as times: the source itself is opened already, by the exact ones.
RenderJob job_for(const RenderSettings& settings);

}  // namespace vvr
