#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/console.h"
#include "cli/exit_status.h"
#include "cli/log.h"
#include "cli/options/command_line.h"
#include "cli/workers/worker_message.h"
#include "core/base/setting.h"

namespace vvr::commands {

using Arguments = std::span<const std::string>;

/// A command: its options and what it does.
class Command {
  public:
    virtual ~Command() = default;

    /// Adds the command's own options; those that all commands share are added elsewhere.
    virtual void add_options(options::CommandLine& line) = 0;

    /// What the command reads besides what its arguments and options name. The options have been parsed.
    virtual std::vector<std::string> also_reads() { return {}; }

    /// Runs the command. The options have been parsed.
    virtual cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) = 0;
};

/// An option of several commands.
inline constexpr Setting json_option{"json", "", "print JSON for programs; null where there is no value"};

/// One row of the table of commands.
struct CommandRow {
    std::string_view name;
    std::string_view help;
    std::unique_ptr<Command> (*make)();
};

std::unique_ptr<Command> make_render();
std::unique_ptr<Command> make_watch();
std::unique_ptr<Command> make_extract();
std::unique_ptr<Command> make_seeds_command();
std::unique_ptr<Command> make_inspect();
std::unique_ptr<Command> make_cut();
std::unique_ptr<Command> make_archive();
std::unique_ptr<Command> make_compare();
std::unique_ptr<Command> make_golden();
std::unique_ptr<Command> make_info();
std::unique_ptr<Command> make_config();
std::unique_ptr<Command> make_doctor();

/// Every command, in the order of `vvr --help`.
inline constexpr std::array command_rows{
    CommandRow{"render", "draw a video as one picture", make_render},
    CommandRow{"watch", "draw a live stream as a picture that is replaced after each brick", make_watch},
    CommandRow{"extract", "write the data files of a video: scalar fields, flow, seeds", make_extract},
    CommandRow{"seeds", "choose seeds on a stored flow, and write them as lists", make_seeds_command},
    CommandRow{"inspect", "show one frame's object, flow and seeds side by side, or draw regions on it", make_inspect},
    CommandRow{"cut", "cut an event, or any other piece, out of a clip", make_cut},
    CommandRow{"archive", "draw every new clip of a folder, with pages and an index", make_archive},
    CommandRow{"compare", "compare two pictures within a tolerance", make_compare},
    CommandRow{"golden", "draw the golden pictures of a folder again, and compare them", make_golden},
    CommandRow{"info", "describe a video, and what a render of it does and needs", make_info},
    CommandRow{"config", "show the active config file, and what it sets", make_config},
    CommandRow{"doctor", "show what works on this machine, and how to fix the rest", make_doctor},
};

/// What the program logs, and where. Every command has these options.
struct LogOptions {
    bool quiet = false;
    bool verbose = false;
    std::string log_file;  ///< empty = none
    Choice<cli::LogFormat> log_format = "text";
};

/// A command with its command line: its own options and those that every command has.
struct CommandAndLine {
    explicit CommandAndLine(const CommandRow& row);

    std::unique_ptr<Command> command;
    LogOptions log{};
    options::CommandLine line;
};

/// For every command, the options that config files can set.
std::vector<options::CommandNames> names_of_commands();

/// The versions of vvr and its libraries, one per line. OpenGL's renderer is left to `vvr doctor`, as asking for it
/// takes longer than all the rest.
std::string version_text();

/// \throws Error usage when no command has that name
const CommandRow& find_command(const std::string& name);

/// Prints the commands, or with the argument --json all help for programs.
/// \throws Error usage for other arguments
cli::ExitStatus print_help(Arguments arguments);

/// Runs the command line: a command's name and its arguments, or --help.
cli::ExitStatus run_command(Arguments arguments, const cli::Environment& environment);

/// Runs a worker's plan.
cli::ExitStatus run_plan(const workers::WorkerPlan& plan, const cli::Environment& environment);

}  // namespace vvr::commands
