#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace vvr::cli {

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

}  // namespace vvr::cli
