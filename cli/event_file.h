#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>

#include <spdlog/logger.h>

#include "cli/appended_file.h"
#include "core/tracking/event_line.h"

namespace vvr::cli {

/// Where other programs read the events of a run, one line of JSON each: a file to which lines are appended, a named
/// pipe, or standard output (`-`). A line that can't be written is lost; the log says so once, and the run goes on.
class EventFile {
  public:
    /// \param path empty = nowhere
    /// \throws Error io if it can't be written, or if it is a file of another kind
    EventFile(std::filesystem::path path, spdlog::logger& log);

    void add(const tracking::EventLine& line);

    /// Logs how many lines were lost.
    /// \returns whether none was
    bool finish();

  private:
    std::filesystem::path path_;
    spdlog::logger& log_;
    std::optional<AppendedFile> file_;
    int error_ = 0;  ///< of the last line that was lost, as in errno
    std::size_t lost_ = 0;
};

}  // namespace vvr::cli
