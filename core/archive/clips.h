#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vvr::archive {

/// Decides by its name whether a file of an archive is a clip.
class ClipNames {
  public:
    /// Chooses clips by name.
    /// \param patterns for `fnmatch`. One with a `/` matches the path below the archive's folder, others match the
    ///        file's name. None = the extensions of video files
    /// \param excluded patterns of files that are not clips, even if they match
    /// \param pictures whether snapshots of cameras are clips too
    explicit ClipNames(std::vector<std::string> patterns = {}, std::vector<std::string> excluded = {},
                       bool pictures = false)
        : patterns_(std::move(patterns)), excluded_(std::move(excluded)), pictures_(pictures) {}

    bool matches(const std::string& clip) const;

    /// The same without exclusions, and with the extensions of video files: an excluded clip still exists.
    ClipNames with_all() const;

    /// For messages: "*.avi", or the extensions of video files.
    std::string wanted() const;

  private:
    std::vector<std::string> patterns_;
    std::vector<std::string> excluded_;
    bool pictures_;
    bool videos_ = patterns_.empty();  ///< files with the extensions of video files are clips too
};

/// What is known of a clip's file without opening it.
struct Clip {
    std::string path;  ///< below the archive's folder
    std::int64_t size = 0;
    std::int64_t modified = 0;  ///< nanoseconds since 1970; clamped to 1970 to 2199
};

/// Judges file times: which clips are still being written, and which have impossible times.
struct Settling {
    std::chrono::system_clock::time_point now;
    std::chrono::nanoseconds settle{};

    /// Whether a clip changed less than `settle` ago. A clock that is far ahead of ours must not delay a clip for
    /// years.
    bool waits_for(const Clip& clip) const;

    /// Whether a clip has a future time: the clock of a camera or server is ahead, or ours was set back.
    bool is_ahead(const Clip& clip) const;
};

/// A place in an archive that could not be read.
struct ScanProblem {
    std::string path;  ///< below the archive's folder; empty = the folder itself
    std::string reason;
    bool unread = false;  ///< which clips it has is unknown
};

struct Scan {
    std::vector<Clip> clips;               ///< by path
    std::vector<ScanProblem> problems;     ///< by path
    std::set<std::string> system_folders;  ///< those that were skipped although they have clips
    std::size_t skipped = 0;               ///< clips in these, at least
};

/// Finds all clips below a folder. Each folder is read once, however many links lead to it, and under its own name if
/// possible. Hidden files and folders are skipped, as are `out`, folders of kept pieces, recycle bins and snapshots of
/// a NAS, and file systems of the kernel (/proc, /sys). A link to a folder that contains `in` is a problem, and is not
/// followed. \throws Error io if the folder itself can't be read
Scan scan_archive(const std::filesystem::path& in, const std::filesystem::path& out, const ClipNames& names);

/// The file's current size and time; nothing if it no longer exists.
std::optional<Clip> stat_clip(const std::filesystem::path& in, const std::string& path);

/// A stable share of the clips: those whose path has a 64-bit FNV-1a hash of `index` modulo `count`.
struct Shard {
    std::uint64_t index = 0;  ///< from 0
    std::uint64_t count = 1;

    bool contains(std::string_view clip) const;
};

}  // namespace vvr::archive
