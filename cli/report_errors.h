#pragma once

#include <functional>
#include <string>

#include <spdlog/logger.h>

#include "cli/exit_status.h"
#include "core/base/error.h"

namespace vvr::cli {

/// A text with the options of the settings that it is about: `threshold: 300 ...` becomes `--threshold: 300 ...`, and
/// what the text does not begin with follows in brackets.
std::string with_flags(const std::string& text, const RelatedSettings& about);

/// Runs `action`; whatever it throws becomes a line for people and an exit status. The one place that does so.
ExitStatus report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action);

/// Makes a program that a library ends with std::terminate, for want of memory or of a thread, end with status 5 and
/// its line. What is half written then has a hidden name, and goes at the next run.
void install_terminate_handler();

}  // namespace vvr::cli
