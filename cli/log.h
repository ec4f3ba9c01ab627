#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <spdlog/logger.h>

#include "core/base/choice.h"
#include "core/base/error.h"

namespace vvr::cli {

/// A logger to stderr, each line `vvr: text`, or `vvr: warning: text`.
std::shared_ptr<spdlog::logger> make_log();

/// Says what went wrong. A line for people ends with the code's name in square brackets, as a compiler's warnings do; a
/// line of JSON has it as `code`.
void log_error(spdlog::logger& log, ErrorCode code, std::string_view text);

/// How much a logger says on stderr.
enum class Verbosity { quiet, normal, verbose };

void set_verbosity(spdlog::logger& log, Verbosity verbosity);

/// One row of the table of formats.
struct LogFormat {
    std::string_view name;
    std::string_view help;
    /// \param timed whether a line for people begins with its time
    std::unique_ptr<spdlog::formatter> (*make)(bool timed);
};

std::span<const LogFormat> log_formats();
const LogFormat& row_of(Name<LogFormat> name);

/// The form of the lines on stderr.
void set_format(spdlog::logger& log, const LogFormat& format);

/// Sends all lines, however much is said on stderr, to the end of a file too. A file that is moved away or deleted, as
/// logrotate does, is made anew at the next line.
/// \throws Error io when it can't be written
void add_file(spdlog::logger& log, const std::string& path, const LogFormat& format);

/// Keeps the warnings that are said from now on, however much is said on stderr.
/// \returns what gives them
std::function<std::vector<std::string>()> keep_warnings(spdlog::logger& log);

}  // namespace vvr::cli
