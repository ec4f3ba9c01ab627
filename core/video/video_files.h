#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vvr::video {

/// The extensions of video files, with their dots, in lower case, sorted.
const std::vector<std::string>& video_extensions();

/// Whether a file name has a video extension.
bool is_video_name(const std::string& name);

/// Whether a file name has a picture extension.
bool is_picture_name(const std::string& name);

/// Size limit of a list of files, bytes.
inline constexpr std::uintmax_t most_list_bytes = 16 * 1024 * 1024;

/// The video files in a folder and its subfolders, in any order. Skips hidden files and folders, and does not follow
/// symbolic links to folders.
/// \throws Error io if the folder can't be read
std::vector<std::string> video_files_in(const std::filesystem::path& folder);

/// Modification time of a file, seconds since 1970 (UTC). Empty if it is not a regular file.
std::optional<double> modified_at(const std::string& path);

/// Natural order: "frame2" comes before "frame10". Runs of digits compare by value, other text by bytes. Names that
/// differ only in leading zeros compare by bytes.
bool natural_less(std::string_view a, std::string_view b);

/// The paths that match a glob (`day/*.mp4`), sorted.
/// \throws Error usage for a pattern longer than PATH_MAX
std::vector<std::string> expand_glob(const std::string& pattern);

}  // namespace vvr::video
