#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <spdlog/logger.h>

namespace vvr {

/// How the program runs: the same in every command.
struct RunOptions {
    bool quiet = false;
    bool verbose = false;
    int threads = 0;                  ///< 0 = one for each core
    std::string log_file;             ///< empty = none
    std::string log_format = "text";  ///< "text" or "json"
};

/// Which OpenGL draws.
struct BackendOptions {
    std::string backend = "auto";
    int device = -1;
};

void add_options(CLI::App& app, RunOptions& options);

/// Only those about what is said, for a command that has nothing to share out among threads.
void add_talk_options(CLI::App& app, RunOptions& options);

void add_options(CLI::App& app, BackendOptions& options);

/// Makes the log as talkative as asked for.
void apply(const RunOptions& options, spdlog::logger& log);

}  // namespace vvr
