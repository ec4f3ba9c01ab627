#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/environment.h"
#include "cli/exit_status.h"

namespace vvr {

using Arguments = std::span<const std::string>;

/// One row of the table of commands.
struct Command {
    std::string name;
    std::string help;
    ExitStatus (*run)(const Command& command, Arguments arguments, const Environment& environment);
};

/// Every command.
const std::vector<Command>& commands();

/// Runs the command that the first argument names, with the others; --help as well.
ExitStatus run_command(Arguments arguments, const Environment& environment);

ExitStatus run_render(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_watch(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_extract(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_inspect(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_archive(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_compare(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_info(const Command& command, Arguments arguments, const Environment& environment);
ExitStatus run_doctor(const Command& command, Arguments arguments, const Environment& environment);

}  // namespace vvr
