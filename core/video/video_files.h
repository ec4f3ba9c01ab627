#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vvr::video {

/// The endings that video files have, with their dots, in lower case and in order.
const std::vector<std::string>& video_extensions();

/// Whether a file's name has one of them.
bool is_video_name(const std::string& name);

/// The video files in a folder and in those below it, in any order. Hidden files and folders are left out, and links to
/// folders are not followed.
/// \throws Error io when the folder can't be read
std::vector<std::string> video_files_in(const std::filesystem::path& folder);

}  // namespace vvr::video
