#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <spdlog/logger.h>

#include "cli/app/observer.h"
#include "cli/signals.h"

namespace vvr::cli {

/// What main hands to every command.
struct Environment {
    spdlog::logger& log;  ///< to people, on stderr
    Signals& signals;
    bool quiet = false;  ///< nothing is said unless it fails
};

/// Writes `text`, data for the user, to stdout. A reader that has seen enough, as `head` has, is no error.
/// \throws Error io
void print(std::string_view text);

/// A bar on stderr that shows how far a run is.
class Progress {
  public:
    /// \param total frames that are expected, 0 = unknown
    Progress(std::string what, std::int64_t total);
    /// Removes the bar, so that a line can be written.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void set(std::int64_t done);

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    std::int64_t total_;
    Clock::time_point next_ = Clock::now();
};

/// Whether stderr is a terminal on which a bar can be drawn.
bool stderr_is_terminal();

/// Shows a run to people: a bar, and lines in the log. Signals wait for files that are being written.
class Console final : public app::Observer {
  public:
    /// \param bar whether a bar shows how far the run is; only a terminal gets one, and only where others are not quiet
    Console(const Environment& environment, bool bar = true);

    void frames(std::int64_t done, std::int64_t expected) override;
    void debug(const std::string& text) override;
    void info(const std::string& text) override;
    void warn(const std::string& text, const RelatedSettings& about = {}) override;
    std::unique_lock<std::mutex> guard() override;

  private:
    void clear();

    const Environment& environment_;
    bool bar_;
    std::mutex mutex_;
    std::optional<Progress> progress_;
};

}  // namespace vvr::cli
