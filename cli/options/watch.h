#pragma once

#include "cli/options/command_line.h"
#include "cli/render/watch.h"

namespace vvr {

void add_stream_options(CommandLine& line, StreamOptions& options);

/// The one option of an output that a stream has.
void add_stream_output(CommandLine& line, OutputOptions& options);

/// \throws Error usage for what only a clip with an end can have
void check_stream(const CommandLine& line, const RenderJob& job);

}  // namespace vvr
