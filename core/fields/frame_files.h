#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace vvr::fields {

/// The files of a folder that belong to frames of a clip, by frame: the number at the end of a name is that of the
/// frame, counted from 0, as `vvr extract` names its files. Files with other extensions don't count.
/// \param extensions with their dots, in lower case
/// \throws Error io for a folder that can't be read, and for two files of one frame; usage for a name without a number
std::map<std::int64_t, std::filesystem::path> files_by_frame(const std::filesystem::path& folder,
                                                             const std::vector<std::string_view>& extensions);

/// The files of another program for the frames of a clip, one per frame: scalar fields or flow.
class FrameFiles {
  public:
    /// \param setting that names the folder, for messages
    /// \throws Error io as above, and if the folder has no such file
    FrameFiles(std::string_view setting, const std::filesystem::path& folder,
               const std::vector<std::string_view>& extensions);

    /// Null if the frame has no file.
    const std::filesystem::path* find(std::int64_t frame) const;

    /// \throws Error io if the frame has no file
    const std::filesystem::path& of(std::int64_t frame) const;

    std::int64_t last() const { return files_.rbegin()->first; }

    /// \param frames of the whole clip, known after its last frame
    /// \throws Error io if there are files for more frames
    void check_end(std::int64_t frames) const;

  private:
    std::string_view setting_;
    std::filesystem::path folder_;
    std::map<std::int64_t, std::filesystem::path> files_;
};

}  // namespace vvr::fields
