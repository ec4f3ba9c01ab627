#include "cli/options/help.h"

#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/exit_status.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/version.h"

namespace vvr::commands {

namespace {

using Json = nlohmann::ordered_json;

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
    Json commands = Json::array();
    for (const CommandRow& row : command_rows) commands.push_back(options::help_json(CommandAndLine(row).line.help()));
    Json environment = Json::array();
    for (const Variable& variable : variables)
        environment.push_back({{"name", variable.name}, {"help", variable.help}});
    Json statuses = Json::array();
    for (const cli::StatusHelp& row : cli::exit_statuses()) {
        statuses.push_back({{"status", row.status}, {"help", row.meaning}});
    }
    return {{"help_format", 1},
            {"vvr", version()},
            {"summary", summary},
            {"commands", std::move(commands)},
            {"groups", options::groups_json()},
            {"values", options::value_kinds_json()},
            {"presets", options::presets_json()},
            {"environment", std::move(environment)},
            {"exit_statuses", std::move(statuses)}};
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
