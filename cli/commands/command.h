#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/console.h"
#include "cli/exit_status.h"
#include "cli/options/command_line.h"

namespace vvr::commands {

using Arguments = std::span<const std::string>;

/// What a command takes, and does.
class Command {
  public:
    virtual ~Command() = default;

    /// Adds the command's options, beside those of every command.
    virtual void add_options(options::CommandLine& line) = 0;

    /// Does the work, once the options have their values.
    virtual cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) = 0;
};

/// One row of the table of commands.
struct CommandRow {
    std::string_view name;
    std::string_view help;
    std::unique_ptr<Command> (*make)();
};

/// Every command.
std::span<const CommandRow> commands();

/// The options that config files can set, of every command.
std::vector<options::CommandNames> names_of_commands();

/// \throws Error usage when there is no command of that name
const CommandRow& find_command(const std::string& name);

/// Runs the command that the first argument names, with the others; --help as well.
cli::ExitStatus run_command(Arguments arguments, const cli::Environment& environment);

std::unique_ptr<Command> make_render();
std::unique_ptr<Command> make_watch();
std::unique_ptr<Command> make_extract();
std::unique_ptr<Command> make_seeds_command();
std::unique_ptr<Command> make_inspect();
std::unique_ptr<Command> make_cut();
std::unique_ptr<Command> make_archive();
std::unique_ptr<Command> make_compare();
std::unique_ptr<Command> make_info();
std::unique_ptr<Command> make_config();
std::unique_ptr<Command> make_doctor();

}  // namespace vvr::commands
