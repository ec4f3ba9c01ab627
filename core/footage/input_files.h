#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Which files an input names: by their extensions, in folders, by globs and in lists.
namespace vvr::footage {

/// The extensions of video files, with their dots, in lower case, sorted.
const std::vector<std::string>& video_extensions();

/// Whether a file name has a video extension.
bool is_video_name(const std::string& name);

/// Whether a file name has a picture extension.
bool is_picture_name(const std::string& name);

/// Whether a folder has the name of one in which a NAS or a system keeps what was deleted, copies of earlier states, or
/// data of its own: `#recycle`, `@Recently-Snapshot`, `lost+found`.
bool is_system_folder_name(const std::string& name);

/// The video files in a folder and its subfolders, in any order. Skips hidden files and folders and those of the
/// system, and does not follow symbolic links to folders. \throws Error io if the folder can't be read
std::vector<std::string> video_files_in(const std::filesystem::path& folder);

/// Natural order: "frame2" comes before "frame10". Runs of digits compare by value, other text by bytes. Names that
/// differ only in leading zeros compare by bytes.
bool natural_less(std::string_view a, std::string_view b);

/// The paths that match a glob (`day/*.mp4`), sorted.
/// \throws Error usage for a pattern longer than PATH_MAX
std::vector<std::string> expand_glob(const std::string& pattern);

/// Whether a file is a list of files. Its content decides too, because a video may have any name.
bool is_list(const std::string& name);

/// The files in a list. Lists are untrusted, so paths outside the list's folder are rejected.
/// \throws Error io if it can't be read, limit if it is too large, usage for a wrong path
std::vector<std::string> files_of_list(const std::string& list);

/// The files of a picture sequence, in natural order. `name` is a folder, a glob (`dir/*.png`) or a printf pattern
/// (`dir/%05d.png`). Empty if it is none of these, or if a file has that name.
///
/// \throws Error io if the folder can't be read or no file matches, not_video for a folder without pictures, usage for
///         a pattern with several numbers or other conversions
std::optional<std::vector<std::string>> list_pictures(const std::string& name);

/// The local files that may be read for the input `name`: a file, the files of a folder, glob or list, the file behind
/// stdin (`-`), or the file with an address (`@FILE`). Includes clips, pictures and parts of extractions. Omits what
/// can't be accessed; opening the input reports that.
std::vector<std::filesystem::path> files_of_input(const std::string& name);

}  // namespace vvr::footage
