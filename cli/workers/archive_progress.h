#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "cli/console.h"

namespace vvr::workers {

/// A clip that a worker is drawing.
struct ClipProgress {
    std::string name;
    std::int64_t bytes = 0;  ///< of the clip
    double part = 0;         ///< of its frames that has been read; 1 = its picture is being drawn
};

/// How far a run has come. The time that a clip takes is estimated by its size.
struct ArchiveProgress {
    std::size_t clips = 0;
    std::size_t finished = 0;
    std::int64_t bytes = 0;           ///< of all clips
    std::int64_t finished_bytes = 0;  ///< of the finished ones
};

/// One line: "archive [=====     ] 52 %, 2 min left; 3 of 12 clips; gate/08.mp4 40 %, hall/08.mp4 is drawn".
/// \param seconds since the run began
/// \param columns of the terminal; a longer line is cut
std::string progress_text(const ArchiveProgress& progress, std::span<const ClipProgress> running, double seconds,
                          std::size_t columns);

/// That line on a terminal, and nothing elsewhere or with --quiet.
class ArchiveBar {
  public:
    explicit ArchiveBar(const cli::Environment& environment);
    ~ArchiveBar() { clear(); }
    ArchiveBar(const ArchiveBar&) = delete;
    ArchiveBar& operator=(const ArchiveBar&) = delete;

    bool is_shown() const { return shown_; }

    void show(const ArchiveProgress& progress, std::span<const ClipProgress> running);

    /// Erases the line, so that a line can be logged.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;

    bool shown_;
    bool is_there_ = false;
    Clock::time_point begin_ = Clock::now();
    Clock::time_point next_ = begin_;
};

}  // namespace vvr::workers
