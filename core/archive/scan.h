#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/archive/clip_names.h"

namespace vvr::archive {

/// A clip's file, as it is known without opening it.
struct Clip {
    std::string path;  ///< below the archive's folder
    std::int64_t size = 0;
    std::int64_t modified = 0;  ///< nanoseconds since 1970; of times before that and after 2199, the nearest
};

/// By the times of their files: which clips are still being written, and which have a time that can't be.
struct Settling {
    std::chrono::system_clock::time_point now;
    std::chrono::nanoseconds settle{};

    /// Whether a clip changed less than `settle` ago. A clock that runs far ahead of ours must not keep a clip waiting
    /// for years.
    bool waits_for(const Clip& clip) const;

    /// Whether a clip has a time of the future: the clock of a camera or of a server is ahead, or ours was set back.
    bool is_ahead(const Clip& clip) const;
};

/// A place in an archive that could not be read.
struct ScanProblem {
    std::string path;  ///< below the archive's folder; empty = the folder itself
    std::string reason;
    bool unread = false;  ///< nobody knows which clips are there
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
std::optional<Clip> stat_clip(const std::filesystem::path& in, const std::string& path);

}  // namespace vvr::archive
