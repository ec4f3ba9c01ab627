#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/base/av_muxer.h"

namespace vvr {

/// Checks that `replace_file` can write to `path`: its folder exists and is writable, and `path` is either free or a
/// writable regular file.
/// \throws Error io if it can't
void check_file_path(const std::filesystem::path& path);

/// Replaces a file atomically: writes `bytes` to a hidden temporary file in the same folder, syncs it and renames it to
/// `path`. A symbolic link at `path` is followed. Also removes abandoned temporary files of the same `path`: those that
/// nobody has locked and, on a network file system, that are at least an hour old.
/// \throws Error io if it can't be written
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// As replace_file, but replaces a symbolic link at `path` itself, like rename(2). Use it in folders where untrusted
/// users can create links.
void replace_link(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// As replace_file, for files that are too large for memory. If `write` throws, `path` is unchanged.
///
/// \param write writes the temporary file
/// \throws Error io if it can't be written, and whatever `write` throws
void replace_file(const std::filesystem::path& path, const std::function<void(const WriteAt&)>& write);

/// Whether a file is a temporary one, abandoned or not, of a file with this name in the same folder.
bool is_temporary_of(const std::string& name, const std::filesystem::path& file);

/// Removes abandoned temporary files of `names` in `folder`. The caller must ensure that no program is replacing these
/// files.
void remove_leftovers(const std::filesystem::path& folder, std::span<const std::string> names);

}  // namespace vvr
