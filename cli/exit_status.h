#pragma once

#include <functional>
#include <optional>
#include <string>

#include <spdlog/logger.h>

#include "core/base/error.h"

namespace vvr::cli {

/// What the program says to the shell. A run that SIGINT, SIGTERM or SIGHUP ends dies of that signal, which a shell
/// shows as 130, 143 or 129.
enum class ExitStatus {
    done = 0,
    usage = 1,      ///< the command line or a config file
    io = 2,         ///< a file can't be read or written
    not_video = 3,  ///< the input is not usable video
    backend = 4,    ///< no OpenGL backend, or OpenGL failed; or no sandbox where one is required
    limit = 5,      ///< out of memory, or over a stated limit
    partial = 6,    ///< some of several inputs failed
    differs = 7,    ///< a picture differs from its golden one, or there is none
    bug = 70,       ///< an error that vvr should have foreseen
};

ExitStatus exit_status(ErrorKind kind);

/// The general code of what ends with a status; nothing where no error does.
std::optional<ErrorCode> code_of_status(int status);

/// A text with the options of the settings that it is about: `threshold: 300 ...` becomes `--threshold: 300 ...`, and
/// what the text does not begin with follows in brackets.
std::string with_flags(const std::string& text, const RelatedSettings& about);

/// What came of a run.
struct Outcome {
    ExitStatus status = ExitStatus::done;
    std::optional<ErrorCode> code{};  ///< of the error that ended it; none = nothing was thrown
    std::string text{};               ///< of that error, for people
};

/// Runs `action`; whatever it throws becomes a line for people, a code and an exit status. The one place that does so.
Outcome report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action);

/// Makes a program that a library ends with std::terminate, for want of memory or of a thread, end with status 5 and
/// its line. What is half written then has a hidden name, and goes at the next run.
void install_terminate_handler();

}  // namespace vvr::cli
