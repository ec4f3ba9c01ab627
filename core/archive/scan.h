#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/archive/clip_names.h"

namespace vvr {

/// A clip's file, as it is known without opening it.
struct Clip {
    std::string path;  ///< below the archive's folder
    std::int64_t size = 0;
    std::int64_t modified = 0;  ///< nanoseconds since 1970
};

/// A place in an archive that could not be read.
struct ScanProblem {
    std::string path;  ///< below the archive's folder; empty = the folder itself
    std::string reason;
};

struct Scan {
    std::vector<Clip> clips;            ///< by path
    std::vector<ScanProblem> problems;  ///< by path
};

/// Finds every clip below a folder. Each folder is read once, however many links lead to it, and under its own name
/// rather than a link's. Hidden files and folders are skipped, and so are `out` and what the kernel shows as folders
/// (/proc, /sys). A link to a folder that holds `in` is a problem, and not followed.
/// \throws Error io when the folder itself can't be read
Scan scan_archive(const std::filesystem::path& in, const std::filesystem::path& out, const ClipNames& names);

/// The file's size and time now; nothing when it no longer exists.
std::optional<Clip> look_at_clip(const std::filesystem::path& in, const std::string& path);

}  // namespace vvr
