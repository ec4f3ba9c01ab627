#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/options/command_line.h"

// Whether the files that a run writes collide with each other, or with those that it reads.
namespace vvr::options {

/// Refuses two outputs with one name, or of which one may be a picture of the other's series or a file of the other's
/// folder.
/// \throws Error options_conflict
void check_outputs_differ(const CommandLine& line);

/// What a run reads: all that arguments and options name, and the config file.
std::vector<std::string> inputs_of(const CommandLine& line);

/// Refuses outputs that are also inputs, as footage may be evidence. Compares files, not names: every input, down to
/// each file of a recording, with everything that the line names for writing, including the log. Call it before any
/// file is opened for writing.
/// \param inputs those of the line, and whatever else is read
/// \throws Error usage
void check_no_input_overwritten(const CommandLine& line, std::span<const std::string> inputs);

}  // namespace vvr::options
