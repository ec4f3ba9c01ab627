#pragma once

#include "cli/options/command_line.h"

// Whether the files that a run writes collide with each other, or with those that it reads.
namespace vvr::options {

/// Refuses two outputs with one name, or of which one may be a picture of the other's series.
/// \throws Error options_conflict
void check_outputs_differ(const CommandLine& line);

/// Refuses outputs that are also inputs, as footage may be evidence. Compares files, not names: everything that
/// arguments, options and the config file name for reading, down to each file of a recording, with everything named for
/// writing, including the log. Call it before any file is opened for writing.
/// \throws Error usage
void check_no_input_overwritten(const CommandLine& line);

}  // namespace vvr::options
