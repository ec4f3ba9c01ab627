#pragma once

#include <string>

#include <spdlog/logger.h>

#include "cli/options/command_line.h"

namespace vvr::options {

/// What the program says, and where: the same in every command.
struct TalkOptions {
    bool quiet = false;
    bool verbose = false;
    std::string log_file;             ///< empty = none
    std::string log_format = "text";  ///< "text" or "json"
};

void add_talk_options(CommandLine& line, TalkOptions& options);

/// Makes the log as talkative as asked for.
void apply(const TalkOptions& options, spdlog::logger& log);

}  // namespace vvr::options
