#pragma once

#include <functional>

#include <spdlog/logger.h>

#include "cli/exit_status.h"

namespace vvr {

/// Runs `action`; whatever it throws becomes a line for people and an exit status. The one place that does so.
ExitStatus report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action);

}  // namespace vvr
