#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vvr {

/// Which files of an archive are clips, by their names.
class ClipNames {
  public:
    /// \param patterns for `fnmatch`: one with a `/` is for the path below the archive's folder, others are for the
    ///        file's name; none = the endings of video files
    explicit ClipNames(std::vector<std::string> patterns = {}) : patterns_(std::move(patterns)) {}

    bool matches(const std::string& clip) const;

  private:
    std::vector<std::string> patterns_;
};

}  // namespace vvr
