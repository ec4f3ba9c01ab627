#pragma once

#include "cli/options_bricks.h"
#include "cli/options_fields.h"
#include "cli/options_input.h"
#include "cli/options_look.h"
#include "cli/options_run.h"
#include "cli/options_view.h"

namespace vvr {

/// Everything that says how a picture comes about; `render` does it, `info` only says what it would take.
struct RenderJob {
    InputOptions input;
    FieldOptions fields;
    BrickOptions bricks;
    ViewOptions view;
    LookOptions look;
    BackendOptions backend;
    RunOptions run;
};

/// Adds all the groups of options.
void add_options(CLI::App& app, RenderJob& job);

/// What no single option can know: an input is there, times are in order.
/// \throws Error usage
void check(const RenderJob& job);

}  // namespace vvr
