#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <spdlog/logger.h>

#include "cli/plan/observer.h"
#include "cli/signals.h"

namespace vvr::cli {

/// What main passes to every command.
struct Environment {
    spdlog::logger& log;  ///< for people, on stderr
    Signals& signals;
    bool quiet = false;                           ///< log errors only
    std::function<void(double part)> progress{};  ///< in a worker: receives which part of the frames has been read
};

/// Writes `text` to stdout. A closed pipe is not an error, as when `head` has read enough.
/// \throws Error io
void print(std::string_view text);

/// Erases the line of the terminal in which the cursor is.
inline constexpr std::string_view clear_line = "\r\033[K";

/// Writes to stderr at once, without a new line.
void write_on_terminal(std::string_view text);

/// The line of a progress bar: "frames [=====     ] 52 %, 12 s left".
/// \param total number of frames expected; 0 = unknown
/// \param seconds since the first frame; the rest is told only after a few
std::string progress_text(std::string_view what, std::int64_t done, std::int64_t total, double seconds);

/// A progress bar on stderr.
class Progress {
  public:
    explicit Progress(std::string what);
    /// Erases the bar, so that a line can be written.
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// \param total 0 = unknown
    void set(std::int64_t done, std::int64_t total);

    const std::string& what() const { return what_; }

  private:
    using Clock = std::chrono::steady_clock;

    std::string what_;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_;
};

/// Whether stderr is a terminal that can show a progress bar.
bool stderr_is_terminal();

/// Shows the progress of a run: a bar, and lines in the log. Holds back signals while files are written.
class Console final : public app::Observer {
  public:
    /// \param bar whether to show a progress bar. It is shown only on a terminal, and not with --quiet.
    Console(const Environment& environment, bool bar = true);

    void frames(std::int64_t done, std::int64_t expected) override;
    void drawing(std::int64_t done, std::int64_t parts) override;
    void debug(const std::string& text) override;
    void info(const std::string& text) override;
    void warn(const std::string& text, const RelatedSettings& about = {}) override;
    std::unique_lock<std::mutex> guard() override;

  private:
    void clear();
    void show(std::string_view what, std::int64_t done, std::int64_t total);

    const Environment& environment_;
    bool bar_;
    std::mutex mutex_;
    std::optional<Progress> progress_;
};

}  // namespace vvr::cli
