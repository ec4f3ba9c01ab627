#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <spdlog/logger.h>

#include "core/base/error.h"

namespace vvr::cli {

/// The exit status of the program. SIGINT, SIGTERM and SIGHUP kill it instead, which a shell shows as 130, 143 or 129.
enum class ExitStatus {
    done = 0,
    usage = 1,      ///< an error in the command line or a config file
    io = 2,         ///< a file can't be read or written
    not_video = 3,  ///< the input is not usable video
    backend = 4,    ///< no OpenGL backend, or OpenGL failed; or a required sandbox is not available
    limit = 5,      ///< out of memory, or over a stated limit
    partial = 6,    ///< some of several inputs failed
    differs = 7,    ///< a picture differs from its reference, or the reference is missing
    bug = 70,       ///< an error that vvr should have foreseen
};

ExitStatus exit_status(ErrorKind kind);

/// An exit status of the program and its meaning, for help.
struct StatusHelp {
    int status;
    std::string_view meaning;
};

/// All of them, in the order of their numbers.
std::span<const StatusHelp> exit_statuses();

/// The general error code for an exit status; nothing if the status is not an error.
std::optional<ErrorCode> code_of_status(int status);

/// The text with its settings as options: `threshold: 300 ...` becomes `--threshold: 300 ...`. Settings with which the
/// text doesn't begin are appended in brackets.
std::string with_flags(const std::string& text, const RelatedSettings& about);

/// The outcome of a run.
struct Outcome {
    ExitStatus status = ExitStatus::done;
    std::optional<ErrorCode> code{};  ///< of the error that ended the run; none = no error
    std::string text{};               ///< of that error, for people
};

/// Runs `action`. Turns any exception into a log line, an error code and an exit status; nothing else does that.
Outcome report_errors(spdlog::logger& log, const std::function<ExitStatus()>& action);

/// Handles std::terminate, which libraries call when they lack memory or can't start a thread: prints an error and
/// exits with status 5. A partly written file then has a hidden name, and the next run removes it.
void install_terminate_handler();

}  // namespace vvr::cli
