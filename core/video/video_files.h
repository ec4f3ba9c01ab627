#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vvr::video {

/// The endings that video files have, with their dots, in lower case and in order.
const std::vector<std::string>& video_extensions();

/// Whether a file's name has one of them.
bool is_video_name(const std::string& name);

/// Whether a file's name has the ending of a picture.
bool is_picture_name(const std::string& name);

/// The largest text that is read as a list of files.
inline constexpr std::uintmax_t most_list_bytes = 16 * 1024 * 1024;

/// The video files in a folder and in those below it, in any order. Hidden files and folders are left out, and links to
/// folders are not followed.
/// \throws Error io when the folder can't be read
std::vector<std::string> video_files_in(const std::filesystem::path& folder);

/// When a file was last written, seconds since 1970 (UTC); nothing for what is no regular file.
std::optional<double> modified_at(const std::string& path);

/// Whether `a` comes before `b` as people count: "frame2" before "frame10". Runs of digits compare by value, the rest
/// by bytes; names that differ only in leading zeros keep their byte order.
bool natural_less(std::string_view a, std::string_view b);

/// What a pattern of a shell (`day/*.mp4`) names, in order.
/// \throws Error usage for one that is longer than any path
std::vector<std::string> expand_glob(const std::string& pattern);

}  // namespace vvr::video
