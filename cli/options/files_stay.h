#pragma once

#include "cli/options/command_line.h"

namespace vvr::options {

/// What a run reads is never what it writes: footage may be evidence. Whatever the names, it is the files that count:
/// all that the arguments, the options and the config file name for reading, down to each file of a recording, against
/// all that are named for writing, the log too. To be called before anything is opened for writing.
/// \throws Error usage
void check_no_input_overwritten(const CommandLine& line);

}  // namespace vvr::options
