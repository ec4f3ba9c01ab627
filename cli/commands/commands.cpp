#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <iterator>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/command.h"
#include "cli/console.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/options/output_files.h"
#include "core/base/error.h"
#include "core/base/setting.h"

namespace vvr::commands {

namespace {

namespace log_rows {
constexpr Setting quiet{"quiet", "", "print errors only"};
constexpr Setting verbose{"verbose", "", "print more"};
constexpr Setting log_file{"log-file", "FILE",
                           "also append every line, with its time, to this file, even with --quiet"};
constexpr Setting log_format{"log-format", "NAME", "format of the log"};
}  // namespace log_rows

/// \returns as add_file
std::function<bool()> apply(const LogOptions& options, spdlog::logger& log) {
    if (options.quiet) cli::set_verbosity(log, cli::Verbosity::quiet);
    if (options.verbose) cli::set_verbosity(log, cli::Verbosity::verbose);
    cli::set_format(log, *options.log_format);
    if (options.log_file.empty()) return [] { return true; };
    return cli::add_file(log, options.log_file, *options.log_format);
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
    CommandAndLine all(row);
    if (!fill(all.line)) return cli::ExitStatus::done;
    options::check_outputs_differ(all.line);
    std::vector<std::string> inputs = options::inputs_of(all.line);
    std::ranges::copy(all.command->also_reads(), std::back_inserter(inputs));
    options::check_no_input_overwritten(all.line, inputs);
    const auto is_logged = apply(all.log, environment.log);
    const cli::ExitStatus status =
        all.command->run(all.line, {environment.log, environment.signals, all.log.quiet, environment.progress});
    return status == cli::ExitStatus::done && !is_logged() ? cli::ExitStatus::io : status;
}

cli::ExitStatus run_with(const CommandRow& row, Arguments arguments, const cli::Environment& environment) {
    // An error in the command line comes before its options are known.
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const std::string next = i + 1 < arguments.size() ? arguments[i + 1] : "";
        if (arguments[i] == "--log-format=json" || (arguments[i] == "--log-format" && next == "json"))
            cli::set_format(environment.log, cli::row_of(Name<cli::LogFormat>{"json"}));
    }
    return run_with(row, environment, [&](options::CommandLine& line) {
        if (!line.parse(arguments)) return false;
        check_time_zone();
        return true;
    });
}

}  // namespace

CommandAndLine::CommandAndLine(const CommandRow& row)
    : command(row.make()), line(std::string(row.name), std::string(row.help)) {
    command->add_options(line);
    const options::AddOptions add(line, options::Group::run);
    add(log_rows::quiet, log.quiet, {.letter = 'q'});
    add(log_rows::verbose, log.verbose, {.letter = 'v'});
    line.exclude(log_rows::quiet, log_rows::verbose);
    add(log_rows::log_file, log.log_file, {.use = options::FileUse::written});
    add(log_rows::log_format, log.log_format, cli::log_formats());
    line.add_common(names_of_commands);
}

std::vector<options::CommandNames> names_of_commands() {
    std::vector<options::CommandNames> names;
    for (const CommandRow& row : command_rows) {
        const CommandAndLine one(row);
        names.push_back(
            {std::string(row.name), one.line.configurable(), one.line.configurable(options::picture_groups)});
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
        line.take(plan.inputs, plan.settings, true);
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
    if (name == "help" && arguments.size() == 2 && arguments[1] != "--json") {
        const std::string asked = "--help";
        return run_with(find_command(arguments[1]), std::span(&asked, 1), environment);
    }
    if (name == "--help" || name == "-h" || name == "help") return print_help(arguments.subspan(1));
    if (name == "--version" || name == "-V" || name == "-v" || name == "version") {
        cli::print(version_text() + "OpenGL: `vvr doctor` shows the renderers\n");
        return cli::ExitStatus::done;
    }
    return run_with(find_command(name), arguments.subspan(1), environment);
}

}  // namespace vvr::commands
