#pragma once

#include "cli/options/command_line.h"
#include "cli/workers/archive.h"

namespace vvr {

void add_archive_options(CommandLine& line, ArchiveOptions& options);

/// \throws Error usage for options that contradict each other
void check(const ArchiveOptions& options);

}  // namespace vvr
