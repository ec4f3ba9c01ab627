#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <spdlog/logger.h>

#include "core/base/error.h"
#include "core/base/setting.h"

namespace vvr::cli {

/// A logger to stderr. Its lines are `vvr: text` or `vvr: warning: text`.
std::shared_ptr<spdlog::logger> make_log();

/// Logs an error. A plain line ends with the code's name in square brackets, as a compiler's warnings do; a JSON line
/// has it as the member `code`.
/// \param members further members of a JSON line, as a JSON object
void log_error(spdlog::logger& log, ErrorCode code, std::string_view text, const std::string& members = "{}");

/// How much the logger writes to stderr.
enum class Verbosity { quiet, normal, verbose };

void set_verbosity(spdlog::logger& log, Verbosity verbosity);

/// A row of the table of formats.
struct LogFormat {
    std::string_view name;
    std::string_view help;
    /// \param timed whether plain lines begin with the time
    std::unique_ptr<spdlog::formatter> (*make)(bool timed);
};

std::span<const LogFormat> log_formats();
const LogFormat& row_of(Name<LogFormat> name);

/// Sets the format of the lines on stderr.
void set_format(spdlog::logger& log, const LogFormat& format);

/// Also appends to a file, at least at the normal level whatever the level of stderr. If the file is moved or deleted,
/// as by logrotate, the next line creates it again.
/// \returns a function that tells whether the file has all lines; an error on stderr tells of the first one lost
/// \throws Error io when the file can't be written, is no regular file or no log
std::function<bool()> add_file(spdlog::logger& log, const std::string& path, const LogFormat& format);

/// Collects the first `most` warnings from now on, whatever the level of stderr.
/// \returns a function that returns them
std::function<std::vector<std::string>()> keep_warnings(spdlog::logger& log, std::size_t most);

}  // namespace vvr::cli
