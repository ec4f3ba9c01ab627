#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/archive/clips.h"
#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/base/wall_clock.h"
#include "core/events/event_kind.h"
#include "core/events/path.h"

namespace vvr::archive {

/// What an archive knows of an event of a clip.
struct FoundEvent {
    events::EventKind kind = events::EventKind::moved;
    int number = 0;                      ///< in the picture, the page and the report
    int still = 0;                       ///< tenths of a second for which it kept its place
    std::vector<events::Waypoint> path;  ///< its way, from its first to its last moment

    friend bool operator==(const FoundEvent&, const FoundEvent&) = default;
};

/// The events of a report of `vvr render --report`, with simplified ways; at most `most`, those that last longest.
/// \throws nlohmann::json::exception for what is no report, Error io for a kind that is not in the table
std::vector<FoundEvent> found_events(const nlohmann::ordered_json& report, std::size_t most = 1000);

/// Seconds from its first to its last moment, in tenths.
int length_of(const FoundEvent& event);

/// As a sidecar and the index have it: ["left", 4, 261, 129, 500, 700, 390, 500, 700].
nlohmann::ordered_json json_of(const FoundEvent& event);

/// Older sidecars have the first letter of a kind in place of its name.
/// \throws nlohmann::json::exception for what `json_of` does not make, Error io for a kind that is not in the table
FoundEvent found_event_of(const nlohmann::ordered_json& json);

/// What an archive knows about a clip, as a file beside its picture. Sidecars are the only database.
struct Sidecar {
    enum class State { done, failed };

    Clip clip;             ///< when it was read
    std::string settings;  ///< digest of all settings that change its files
    std::string version;   ///< of the vvr that made them
    State state = State::done;
    int tries = 1;
    int status = 0;                 ///< exit status of the last try
    std::optional<ErrorCode> code;  ///< of what `reason` tells; older sidecars have none
    std::string reason;             ///< why it failed; of one that is done, what is not right
    std::vector<OutputKind> files;
    double took = 0;  ///< seconds that the last try took

    /// Of a day of a camera; none = it is a clip.
    struct Day {
        std::string camera;
        std::string date;
        std::int64_t clips = 0;
        std::vector<std::string> files{};  ///< the paths of its clips; of older sidecars none are known
    };
    std::optional<Day> day;

    /// The clip of which the files are, where it has changed since and could not be drawn again.
    struct Shown {
        Clip clip;             ///< when it was read for them
        std::string settings;  ///< with which they were drawn
    };
    std::optional<Shown> shows;

    // Once it is done; of one that failed, of what its files show.
    std::int64_t frames = 0;
    std::int64_t damaged = 0;
    double seconds = 0;
    std::optional<std::int64_t> events;                ///< if they were searched for
    std::optional<std::string> recorded;               ///< UTC, if anything tells but when the file was last written
    ClockSource recorded_by = ClockSource::container;  ///< what tells that
    std::vector<FoundEvent> found;                     ///< the events
};

/// Writes it whole or not at all. Call it once all files that it names exist.
/// \throws Error io
void write_sidecar(const std::filesystem::path& out, const Sidecar& sidecar);

/// Nothing when there is none, or when `write_sidecar` did not write it for this clip.
std::optional<Sidecar> read_sidecar(const std::filesystem::path& out, const std::string& clip);

/// The sidecar in a file, if it is one and has the path of its clip's sidecar.
/// \param file below `out`
/// \param problem why one that is there can't be read; null = it doesn't matter
std::optional<Sidecar> read_sidecar_file(const std::filesystem::path& out, const std::string& file,
                                         std::string* problem = nullptr);

/// What `write_sidecar` writes.
std::string format_sidecar(const Sidecar& sidecar);

/// The sidecar that a text is; nothing when `format_sidecar` did not make it.
std::optional<Sidecar> parse_sidecar(const std::string& text);

/// Takes frames, length, events and time of recording from a report of `vvr render --report`. A length that no clip has
/// is left out, and `reason` says so.
/// \throws Error io when it is no report
void apply_report(Sidecar& sidecar, const std::filesystem::path& report);

/// What its files show, as `shows` has it: the clip as it is, unless a later try has failed.
Sidecar::Shown shown_by(const Sidecar& sidecar);

/// Removes the files that a sidecar names, then the sidecar.
/// \throws Error io
void remove_outputs(const std::filesystem::path& out, const Sidecar& sidecar);

}  // namespace vvr::archive
