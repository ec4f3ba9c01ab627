#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/log_options.h"
#include "cli/options/output.h"
#include "core/base/error.h"
#include "core/base/setting.h"

namespace vvr::commands {

namespace {

std::string help() {
    std::string text = "vvr: surveillance video as one still picture\n\nUsage: vvr COMMAND [OPTIONS]\n\n";
    for (const CommandRow& command : command_rows) text += fmt::format("  vvr {:<8} {}\n", command.name, command.help);
    text += "\n`vvr COMMAND --help` lists a command's options, `vvr --version` the libraries' versions.\n";
    return text;
}

/// Whether the text looks like an input: people first try `vvr clip.avi`.
bool looks_like_input(const std::string& text) {
    std::error_code none;
    return std::filesystem::exists(text, none) || text.find("://") != std::string::npos ||
           std::filesystem::path(text).has_extension();
}

/// \param fill sets the options; returns false if nothing is left to do, as after --help
cli::ExitStatus run_with(const CommandRow& row, const cli::Environment& environment,
                         const std::function<bool(options::CommandLine&)>& fill) {
    const std::unique_ptr<Command> command = row.make();
    options::LogOptions log;
    options::CommandLine line(std::string(row.name), std::string(row.help));
    line.set_commands(names_of_commands);
    command->add_options(line);
    options::add_log_options(line, log);
    if (!fill(line)) return cli::ExitStatus::done;
    options::check_no_input_overwritten(line);
    options::apply(log, environment.log);
    return command->run(line, {environment.log, environment.signals, log.quiet});
}

cli::ExitStatus run_with(const CommandRow& row, Arguments arguments, const cli::Environment& environment) {
    return run_with(row, environment, [&](options::CommandLine& line) { return line.parse(arguments); });
}

}  // namespace

std::vector<options::CommandNames> names_of_commands() {
    std::vector<options::CommandNames> names;
    for (const CommandRow& row : command_rows) {
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

const CommandRow& find_command(const std::string& name) {
    const auto row = std::ranges::find(command_rows, name, &CommandRow::name);
    if (row == command_rows.end()) {
        if (looks_like_input(name)) {
            throw Error(
                ErrorCode::command_unknown,
                fmt::format("unknown command '{0}'; to draw that input: vvr render '{0}' -o picture.png", name));
        }
        throw Error(ErrorCode::command_unknown, fmt::format("unknown command '{}'{}; `vvr --help` lists the commands",
                                                            name, did_you_mean(name, names_of(command_rows))));
    }
    return *row;
}

cli::ExitStatus run_plan(const workers::WorkerPlan& plan, const cli::Environment& environment) {
    return run_with(find_command(plan.command), environment, [&](options::CommandLine& line) {
        line.take(plan.inputs, plan.settings);
        return true;
    });
}

cli::ExitStatus run_command(Arguments arguments, const cli::Environment& environment) {
    if (arguments.empty()) {
        throw Error(ErrorCode::command_unknown,
                    fmt::format("no command given; choose one of {}; `vvr --help` describes them",
                                fmt::join(names_of(command_rows), ", ")));
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
        cli::print(version_text() + "OpenGL: `vvr doctor` shows the renderers\n");
        return cli::ExitStatus::done;
    }
    return run_with(find_command(name), arguments.subspan(1), environment);
}

}  // namespace vvr::commands
