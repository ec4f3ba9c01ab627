#pragma once

#include "cli/app/job.h"
#include "cli/options/command_line.h"

namespace vvr::options {

void add_output_options(CommandLine& line, app::OutputOptions& options);

/// Which events count. Shared, so that an event has the same number in every command.
void add_event_options(CommandLine& line, Group group, events::EventChoice& choice);

/// The allowed difference of two pictures, for `compare` and `render --golden`.
void add_comparison_options(CommandLine& line, app::ComparisonOptions& options);

/// \throws Error usage when the diff's format can't be written, io when its folder can't
void check(const app::ComparisonOptions& options);

/// \throws Error usage when no output is named or outputs contradict each other; io when a folder can't be written
void check(const app::OutputOptions& options);

/// \throws Error usage when an animation would show nothing that moves
void check_outputs(const app::RenderJob& job);

/// Refuses outputs that are also inputs, as footage may be evidence. Compares files, not names: everything that
/// arguments, options and the config file name for reading, down to each file of a recording, with everything named for
/// writing, including the log. Call it before any file is opened for writing.
/// \throws Error usage
void check_no_input_overwritten(const CommandLine& line);

}  // namespace vvr::options
