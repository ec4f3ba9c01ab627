#pragma once

#include "cli/options/command_line.h"
#include "cli/render/job.h"

namespace vvr {

/// Layout, camera and size of the picture.
void add_view_options(CommandLine& line, RenderJob& job);

}  // namespace vvr
