#pragma once

#include "cli/app/job.h"
#include "cli/options/command_line.h"

namespace vvr::options {

void add_output_options(CommandLine& line, app::OutputOptions& options);

/// Which events count, as in `render`: so their numbers are the same everywhere.
void add_event_options(CommandLine& line, Group group, events::EventChoice& choice);

/// By how much two pictures may differ: in `compare` and in `render --golden`.
void add_comparison_options(CommandLine& line, app::ComparisonOptions& options);

/// \throws Error usage for a diff of a format that can't be written, io for a place that can't
void check(const app::ComparisonOptions& options);

/// \throws Error usage when nothing says where the picture goes, or outputs contradict each other; io for a place that
/// can't be written
void check(const app::OutputOptions& options);

/// \throws Error usage when an animation shows nothing that moves
void check_outputs(const app::RenderJob& job);

/// What a run reads is never what it writes: footage may be evidence. Whatever the names, it is the files that count:
/// all that the arguments, the options and the config file name for reading, down to each file of a recording, against
/// all that are named for writing, the log too. To be called before anything is opened for writing.
/// \throws Error usage
void check_no_input_overwritten(const CommandLine& line);

}  // namespace vvr::options
