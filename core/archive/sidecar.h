#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/archive/camera_days.h"
#include "core/archive/clips.h"
#include "core/archive/found_events.h"
#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/base/wall_clock.h"

namespace vvr::archive {

/// What a worker may use.
struct TryLimits {
    std::int64_t seconds = 0;  ///< 0 = unlimited
    std::int64_t memory = 0;   ///< bytes
};

/// What an archive knows of a clip, as a file next to its picture. Sidecars are the only database.
struct Sidecar {
    enum class State {
        done,
        failed,
        outside,  ///< it has no frame in the span that is drawn, and no files
    };

    Clip clip;             ///< when it was read
    std::string settings;  ///< digest of all settings that affect its files
    std::string version;   ///< version of vvr that made them
    State state = State::done;
    int tries = 1;
    int status = 0;                   ///< exit status of the last attempt
    std::optional<ErrorCode> code;    ///< code of the error in `reason`; older sidecars have none
    std::string reason;               ///< why it failed; after success, a remaining problem
    std::optional<TryLimits> limits;  ///< the highest so far, after a failure by a limit; older sidecars have none
    std::vector<OutputKind> files;
    std::vector<std::string> pieces;  ///< names of its files in `pieces_folder`
    double took = 0;                  ///< seconds that the last attempt took

    /// For a camera day; nothing for a clip.
    struct Day {
        std::string camera;
        std::string date;
        std::int64_t clips = 0;
        std::vector<std::string> files{};   ///< the paths of its clips; unknown in older sidecars
        DayRule rule{};                     ///< when it begins
        std::vector<std::string> unread{};  ///< files that the picture lacks, as they could not be opened
    };
    std::optional<Day> day;

    /// The state of the clip that the files show, if the clip has changed since and couldn't be drawn again.
    struct Shown {
        Clip clip;             ///< the clip's state then
        std::string settings;  ///< the settings' digest then
    };
    std::optional<Shown> shows;

    // Known after success; after a failure, they describe what the files show.
    std::int64_t frames = 0;
    std::int64_t damaged = 0;
    std::vector<std::string> faults;  ///< of the recording, in a few words each
    double seconds = 0;
    std::optional<std::int64_t> events;                ///< nothing if events weren't searched for
    std::optional<std::string> recorded;               ///< UTC; nothing if only the file's time is known
    ClockSource recorded_by = ClockSource::container;  ///< source of `recorded`
    std::vector<FoundEvent> found;                     ///< the events
    std::vector<int> stills;                           ///< times of the contact sheet's pictures, tenths of a second
};

/// The first name in each sidecar.
inline constexpr const char* sidecar_mark = "vvr-archive";

/// Writes a sidecar atomically. Call it when all files that it names exist.
/// \throws Error io
void write_sidecar(const std::filesystem::path& out, const Sidecar& sidecar);

/// Reads a clip's sidecar; nothing if there is none, or if `write_sidecar` didn't write it for this clip.
std::optional<Sidecar> read_sidecar(const std::filesystem::path& out, const std::string& clip);

/// Reads a file if it is a sidecar with the path that its clip's sidecar has.
/// \param file below `out`
/// \param problem out: why an existing one can't be read; may be null
std::optional<Sidecar> read_sidecar_file(const std::filesystem::path& out, const std::string& file,
                                         std::string* problem = nullptr);

/// The text that `write_sidecar` writes.
std::string format_sidecar(const Sidecar& sidecar);

/// Parses a sidecar's text; nothing if `format_sidecar` didn't make it.
std::optional<Sidecar> parse_sidecar(const std::string& text);

/// Sets frames, duration, events and time of recording from a report (`vvr render --report`). An impossible duration is
/// left out, and `reason` says so. If events have no piece, `reason` and `code` say so.
/// \throws Error io for an invalid report
void apply_report(Sidecar& sidecar, const std::filesystem::path& report);

/// Whether events of a drawn clip have no piece because a file could not be read or written. Another try may succeed.
bool lacks_pieces(const Sidecar& sidecar);

/// Whether the last try failed by a limit that is higher now.
bool is_limit_raised(const Sidecar& sidecar, const TryLimits& now);

/// What its files show: `shows`, or the clip itself unless a later attempt has failed.
Sidecar::Shown shown_by(const Sidecar& sidecar);

/// Removes the files that a sidecar names, its pieces too, then the sidecar. Anything but a regular file stays.
/// \returns what was removed, below `out`
/// \throws Error io
std::vector<std::string> remove_outputs(const std::filesystem::path& out, const Sidecar& sidecar);

}  // namespace vvr::archive
