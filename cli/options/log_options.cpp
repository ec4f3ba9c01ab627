#include "cli/options/log_options.h"

namespace vvr::options {

namespace {

namespace text {
constexpr Setting quiet{"quiet", "", "print errors only"};
constexpr Setting verbose{"verbose", "", "print more"};
constexpr Setting log_file{"log-file", "FILE", "append every line to this file too, with its time, even with --quiet"};
constexpr Setting log_format{"log-format", "NAME", "format of the log"};
}  // namespace text

}  // namespace

void add_log_options(CommandLine& line, LogOptions& options) {
    line.flag(Group::run, options.quiet, text::quiet, {.letter = 'q'});
    line.flag(Group::run, options.verbose, text::verbose, {.letter = 'v'});
    line.exclude(text::verbose, text::quiet);
    line.text(Group::run, options.log_file, text::log_file, {.use = FileUse::written});
    line.choice(Group::run, cli::log_formats(), options.log_format, text::log_format);
}

void apply(const LogOptions& options, spdlog::logger& log) {
    if (options.quiet) cli::set_verbosity(log, cli::Verbosity::quiet);
    if (options.verbose) cli::set_verbosity(log, cli::Verbosity::verbose);
    cli::set_format(log, *options.log_format);
    if (!options.log_file.empty()) cli::add_file(log, options.log_file, *options.log_format);
}

}  // namespace vvr::options
