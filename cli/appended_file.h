#pragma once

#include <filesystem>
#include <span>
#include <string_view>

#include "core/base/file.h"

namespace vvr::cli {

/// What lines are appended to.
struct AppendedKind {
    std::string_view what;  ///< for messages: "cannot write WHAT 'name'"
    bool streams;           ///< whether it may also be a named pipe or standard output (`-`)
    /// How its first line begins, each 0 being any digit. Nothing is appended to a file that begins otherwise.
    std::span<const std::string_view> beginnings;
};

/// A file at whose end lines are written; several programs can share it. If it has been moved or deleted, as by
/// logrotate, the next line goes to a new file.
class AppendedFile {
  public:
    /// \throws Error io if it can't be written, or is of another kind
    AppendedFile(std::filesystem::path path, const AppendedKind& kind);

    /// Waits for a second at most, if the reader of a pipe is busy.
    /// \param line with its end
    /// \returns 0, or the error as in errno: the line is lost
    int append(std::string_view line);

  private:
    int open(std::string_view& fault);
    int write(std::string_view text);

    std::filesystem::path path_;
    AppendedKind kind_;
    Descriptor opened_;          ///< not for standard output
    bool is_file_ = false;       ///< not a pipe or standard output
    bool is_open_line_ = false;  ///< the last line was written in part
};

}  // namespace vvr::cli
