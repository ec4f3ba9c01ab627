#pragma once

#include "cli/options/command_line.h"
#include "cli/plan/settings.h"

// What `vvr render` does, for the commands that draw as it does.
namespace vvr::commands {

/// Adds its options, which fill the job.
void add_render_options(options::CommandLine& line, app::RenderJob& job);

/// Completes the job after its options have been set.
/// \throws Error usage when they contradict each other
void prepare_render(const options::CommandLine& line, app::RenderJob& job);

}  // namespace vvr::commands
