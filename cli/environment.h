#pragma once

#include <spdlog/logger.h>

#include "cli/signals.h"

namespace vvr::cli {

/// What main hands to every command.
struct Environment {
    spdlog::logger& log;  ///< to people, on stderr
    Signals& signals;
    bool quiet = false;  ///< nothing is said unless it fails
};

}  // namespace vvr::cli
