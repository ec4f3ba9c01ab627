#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/log_options.h"
#include "cli/options/output.h"
#include "cli/versions.h"
#include "core/base/choice.h"
#include "core/base/error.h"

namespace vvr::commands {

namespace {

constexpr std::array table{
    CommandRow{"render", "draw a video as one picture", make_render},
    CommandRow{"watch", "draw a live stream as a picture that is replaced after each brick", make_watch},
    CommandRow{"extract", "write the data files of a video: scalar fields, flow, seeds", make_extract},
    CommandRow{"seeds", "choose seeds anew on a flow that is stored, as lists", make_seeds_command},
    CommandRow{"inspect", "show one frame's object, flow and seeds side by side, or draw regions on it", make_inspect},
    CommandRow{"cut", "cut an event, or any piece, out of a clip", make_cut},
    CommandRow{"archive", "draw every new clip of a folder, with pages and an index", make_archive},
    CommandRow{"compare", "compare two pictures within a tolerance", make_compare},
    CommandRow{"info", "describe a video, and what a render of it would do and need", make_info},
    CommandRow{"config", "say which config file is in force, and what it sets", make_config},
    CommandRow{"doctor", "say what this machine can do, and how to fix what it cannot", make_doctor},
};

std::string help() {
    std::string text = "vvr: surveillance video as one still picture\n\nUsage: vvr COMMAND [OPTIONS]\n\n";
    for (const CommandRow& command : table) text += fmt::format("  vvr {:<8} {}\n", command.name, command.help);
    text += "\n`vvr COMMAND --help` lists a command's options, `vvr --version` the libraries' versions.\n";
    return text;
}

/// Whether a text looks like an input: `vvr clip.avi` is what people type first.
bool looks_like_input(const std::string& text) {
    std::error_code none;
    return std::filesystem::exists(text, none) || text.find("://") != std::string::npos ||
           std::filesystem::path(text).has_extension();
}

cli::ExitStatus run_with(const CommandRow& row, Arguments arguments, const cli::Environment& environment) {
    const std::unique_ptr<Command> command = row.make();
    options::LogOptions log;
    options::CommandLine line(std::string(row.name), std::string(row.help));
    line.set_commands(names_of_commands);
    command->add_options(line);
    options::add_log_options(line, log);
    if (!line.parse(arguments)) return cli::ExitStatus::done;
    options::check_no_input_overwritten(line);
    options::apply(log, environment.log);
    return command->run(line, {environment.log, environment.signals, log.quiet});
}

}  // namespace

std::vector<options::CommandNames> names_of_commands() {
    std::vector<options::CommandNames> names;
    for (const CommandRow& row : table) {
        names.push_back({std::string(row.name), [&row] {
                             const std::unique_ptr<Command> command = row.make();
                             options::LogOptions log;
                             options::CommandLine line(std::string(row.name), std::string(row.help));
                             command->add_options(line);
                             options::add_log_options(line, log);
                             return line.configurable();
                         }});
    }
    return names;
}

std::span<const CommandRow> commands() {
    return table;
}

const CommandRow& find_command(const std::string& name) {
    const auto row = std::ranges::find(table, name, &CommandRow::name);
    if (row == table.end()) {
        if (looks_like_input(name)) {
            throw Error(ErrorKind::usage,
                        fmt::format("there is no command '{0}'; to draw it: vvr render '{0}' -o picture.png", name));
        }
        throw Error(ErrorKind::usage, fmt::format("there is no command '{}'{}; `vvr --help` lists them", name,
                                                  did_you_mean(name, names_of(table))));
    }
    return *row;
}

cli::ExitStatus run_command(Arguments arguments, const cli::Environment& environment) {
    if (arguments.empty()) {
        throw Error(ErrorKind::usage, fmt::format("no command; there are {}: `vvr --help` says what they do",
                                                  fmt::join(names_of(table), ", ")));
    }
    const std::string& name = arguments.front();
    if (name == "--help" || name == "-h" || name == "help") {
        if (name == "help" && arguments.size() > 1) {
            const std::string asked = "--help";
            return run_with(find_command(arguments[1]), std::span(&asked, 1), environment);
        }
        cli::print(help());
        return cli::ExitStatus::done;
    }
    if (name == "--version" || name == "-V" || name == "version") {
        cli::print(cli::version_text() + "OpenGL: `vvr doctor` shows the renderers\n");
        return cli::ExitStatus::done;
    }
    return run_with(find_command(name), arguments.subspan(1), environment);
}

}  // namespace vvr::commands
