#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vvr::archive {

/// Which files of an archive are clips, by their names.
class ClipNames {
  public:
    /// \param patterns for `fnmatch`: one with a `/` is for the path below the archive's folder, others are for the
    ///        file's name; none = the endings of video files
    /// \param excluded patterns of what is no clip all the same
    explicit ClipNames(std::vector<std::string> patterns = {}, std::vector<std::string> excluded = {})
        : patterns_(std::move(patterns)), excluded_(std::move(excluded)) {}

    bool matches(const std::string& clip) const;

    /// With all that is a clip by its ending or by a pattern, whatever is excluded: what these names leave out is there
    /// all the same.
    ClipNames with_all() const;

    /// "*.avi", or the endings of video files: for messages.
    std::string wanted() const;

  private:
    std::vector<std::string> patterns_;
    std::vector<std::string> excluded_;
    bool videos_ = patterns_.empty();  ///< those with the endings of video files are clips too
};

}  // namespace vvr::archive
