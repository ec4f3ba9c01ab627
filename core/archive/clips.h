#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/video/recorder_names.h"

namespace vvr::archive {

/// Which files of an archive are clips, by their names.
class ClipNames {
  public:
    /// \param patterns for `fnmatch`: one with a `/` is for the path below the archive's folder, others are for the
    ///        file's name; none = the endings of video files
    /// \param excluded patterns of what is no clip all the same
    explicit ClipNames(std::vector<std::string> patterns = {}, std::vector<std::string> excluded = {})
        : patterns_(std::move(patterns)), excluded_(std::move(excluded)) {}

    bool matches(const std::string& clip) const;

    /// With all that is a clip by its ending or by a pattern, whatever is excluded: what these names leave out is there
    /// all the same.
    ClipNames with_all() const;

    /// "*.avi", or the endings of video files: for messages.
    std::string wanted() const;

  private:
    std::vector<std::string> patterns_;
    std::vector<std::string> excluded_;
    bool videos_ = patterns_.empty();  ///< those with the endings of video files are clips too
};

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

/// A stable share of the clips: those whose path's FNV-1a hash, 64 bits, leaves `index` when divided by `count`.
struct Shard {
    std::uint64_t index = 0;  ///< from 0
    std::uint64_t count = 1;

    bool contains(std::string_view clip) const;
};

/// The day on the wall's calendar: "2026-11-21", in this machine's time zone.
/// \param utc seconds since 1970
std::string date_of(std::int64_t utc);

/// All clips that a camera began on a day.
struct CameraDay {
    std::string camera;              ///< empty = nobody knows
    std::string date;                ///< "2026-11-21", in this machine's time zone
    Clip clip;                       ///< all together: where its files stand, bytes, when the newest was written
    std::vector<std::string> files;  ///< below the archive's folder
};

/// Clips by camera and day.
struct CameraDays {
    std::vector<CameraDay> days;
    std::vector<ScanProblem> problems;  ///< cameras whose names can't be those of folders
    std::size_t waiting = 0;            ///< clips that are still being written, and left out
};

/// Groups clips by camera and day. A clip of which nothing tells when it begins is of the day when it was last written.
CameraDays group_by_day(const std::vector<Clip>& clips, const video::RecorderNames& names, const Settling& settling);

}  // namespace vvr::archive
