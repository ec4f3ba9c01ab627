#pragma once

#include "cli/options/command_line.h"
#include "cli/workers/archive.h"

namespace vvr::options {

void add_archive_options(CommandLine& line, workers::ArchiveOptions& options);

/// \throws Error usage when options contradict each other
void check(const workers::ArchiveOptions& options);

}  // namespace vvr::options
