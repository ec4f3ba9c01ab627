#pragma once

#include <string>

#include <spdlog/logger.h>

#include "cli/log.h"
#include "cli/options/command_line.h"

namespace vvr::options {

/// What the program logs, and where. Every command has these options.
struct LogOptions {
    bool quiet = false;
    bool verbose = false;
    std::string log_file;  ///< empty = none
    Choice<cli::LogFormat> log_format = "text";
};

void add_log_options(CommandLine& line, LogOptions& options);

/// Applies the options to the log.
void apply(const LogOptions& options, spdlog::logger& log);

}  // namespace vvr::options
