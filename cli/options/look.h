#pragma once

#include "cli/options/command_line.h"
#include "cli/render/job.h"

namespace vvr {

/// What the picture shows of the volume and the flow.
void add_look_options(CommandLine& line, RenderJob& job);

}  // namespace vvr
