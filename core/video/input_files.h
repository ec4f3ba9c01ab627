#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace vvr::video {

/// The files that `name` means if it names a sequence of pictures, in natural order: a folder, a glob
/// (`dir/*.png`) or a printf pattern (`dir/%05d.png`). Nothing if it is none of these, or if there is a file of that
/// name.
///
/// \throws Error io when the folder can't be read or no file matches, not_video for a folder without pictures,
///         usage for a pattern with more than one number or other conversions
std::optional<std::vector<std::string>> list_pictures(const std::string& name);

/// The largest text that is read as a list of files.
inline constexpr std::uintmax_t most_list_bytes = 16 * 1024 * 1024;

/// Whether a file's name has the ending of a picture.
bool is_picture_name(const std::string& name);

/// The files of this machine that are read where `name` is given as an input: a file, those that a folder, a pattern or
/// a list names, what stdin is (`-`), or the file that holds an address (`@FILE`). All that may be read counts, be it a
/// clip, a picture, or part of an extraction. What can't be looked at is left out: who opens it says why.
std::vector<std::filesystem::path> files_of_input(const std::string& name);

}  // namespace vvr::video
