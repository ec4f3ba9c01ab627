#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "core/base/av_writer.h"

namespace vvr::image {

/// Checks that `replace_file` can write to `path`: its folder exists and takes new files, and at `path` there is
/// nothing, or a file that may be overwritten.
/// \throws Error io with the next step
void check_file_path(const std::filesystem::path& path);

/// Writes `bytes` to a hidden file beside `path` and renames it once it is safely on the disk: `path` holds all of
/// them, or what it held before. A link is followed, so that it stays a link. Hidden files that killed programs left
/// for the same `path` are removed once it is certain that no program is writing them: their lock is free, and if other
/// machines may be writing, they are an hour old.
/// \throws Error io
void replace_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// The same, but a link at `path` is replaced itself, as by rename(2): where others may make links, what they lead to
/// is not theirs to give.
void replace_link(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// As replace_file, of a file that is too large for memory: `write` puts it together. If it throws, `path` stays as it
/// was. \param check reads the whole file under its hidden name before `path` becomes it; it may throw too \throws
/// Error io; what `write` and `check` throw
void replace_file(const std::filesystem::path& path, const std::function<void(const WriteAt&)>& write,
                  const std::function<void(const std::filesystem::path& written)>& check = {});

/// Removes the hidden files that killed programs left when they were replacing one of `names` in `folder`. The caller
/// has to make sure that no program is replacing them now.
void remove_leftovers(const std::filesystem::path& folder, std::span<const std::string> names);

}  // namespace vvr::image
