#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace vvr {

/// Says whether `replace_file` could write to `path`: its folder is there and takes new files, and nothing but a
/// file that may be overwritten stands in the way.
/// \throws Error io with the next step
void check_file_path(const std::filesystem::path& path);

/// Writes `bytes` to a hidden file beside `path` and renames it once it is safely on the disk: `path` holds all of
/// them, or what it held before. A link is followed, so that it stays a link. What killed programs left of the same
/// `path` goes, once it is certain that nobody is writing it: its lock is free, and where other machines may be writing
/// it has lain for an hour. \throws Error io
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// Removes the hidden files that killed programs left when they were replacing one of `names` in `folder`. Only for who
/// knows that nobody is replacing them now.
void remove_leftovers(const std::filesystem::path& folder, std::span<const std::string> names);

}  // namespace vvr
