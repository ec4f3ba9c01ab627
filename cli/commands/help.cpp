#include "cli/options/help.h"

#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/exit_status.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/version.h"

namespace vvr::commands {

namespace {

constexpr std::string_view summary = "surveillance video as one still picture";

/// A variable of the environment, for help.
struct Variable {
    std::string_view name;
    std::string_view help;
};

constexpr std::array variables{
    Variable{"VVR_CONFIG", "names the config file; empty = no config file"},
    Variable{"VVR_GL_DEBUG",
             "if set, messages of the OpenGL driver become warnings, to report driver problems; slower"},
    Variable{"XDG_CONFIG_HOME", "folder of the user's config file `vvr/vvr.toml`; `~/.config` if not set"},
    Variable{"TMPDIR", "folder for the temporary copy of a clip from stdin; `/var/tmp` if not set"},
    Variable{"TZ", "the time zone for clips whose names do not give one, and for days"},
    Variable{"COLUMNS", "width of `--help` in columns; the terminal's width if not set"},
    Variable{"TERM", "`dumb` = no progress bar"},
};

std::string as_text() {
    std::string text = fmt::format("vvr: {}\n\nUsage: vvr COMMAND [OPTIONS]\n\n", summary);
    for (const CommandRow& command : command_rows) text += fmt::format("  vvr {:<8} {}\n", command.name, command.help);
    return text +
           "\n`vvr COMMAND -h` names a command's options, `vvr COMMAND --help` describes them.\n"
           "`vvr --version` lists the libraries' versions.\n"
           "`vvr help --json` prints all help for programs.\n";
}

Json as_json() {
    const auto command = [](const CommandRow& row) { return options::help_json(CommandAndLine(row).line.help()); };
    const auto variable = [](const Variable& row) { return Json{{"name", row.name}, {"help", row.help}}; };
    const auto status = [](const cli::StatusHelp& row) { return Json{{"status", row.status}, {"help", row.meaning}}; };
    return {{"help_format", 1},
            {"vvr", version()},
            {"summary", summary},
            {"commands", list_of(command_rows, command)},
            {"groups", options::groups_json()},
            {"values", options::value_kinds_json()},
            {"presets", options::presets_json()},
            {"environment", list_of(variables, variable)},
            {"exit_statuses", list_of(cli::exit_statuses(), status)}};
}

}  // namespace

cli::ExitStatus print_help(Arguments arguments) {
    const bool json = arguments.size() == 1 && arguments.front() == "--json";
    if (!arguments.empty() && !json) {
        throw Error(ErrorCode::usage,
                    fmt::format("'{}' is one argument too many; `vvr help` lists the commands, `vvr help COMMAND` the "
                                "options of one, `vvr help --json` prints all help for programs",
                                arguments.back()));
    }
    cli::print(json ? json_text(as_json(), 1) + "\n" : as_text());
    return cli::ExitStatus::done;
}

}  // namespace vvr::commands
