#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/archive/found_event.h"
#include "core/archive/names.h"
#include "core/archive/scan.h"

namespace vvr {

/// What an archive knows about a clip, as a file beside its picture. Sidecars are the only database.
struct Sidecar {
    enum class State { done, failed };

    Clip clip;             ///< when it was read
    std::string settings;  ///< digest of all settings that change its files
    std::string version;   ///< of the vvr that made them
    State state = State::done;
    int tries = 1;
    int status = 0;      ///< exit status of the last try
    std::string reason;  ///< why it failed
    std::vector<OutputKind> files;
    double took = 0;  ///< seconds that the last try took

    /// Of a day of a camera; none = it is a clip.
    struct Day {
        std::string camera;
        std::string date;
        std::int64_t clips = 0;
    };
    std::optional<Day> day;

    // Once it is done.
    std::int64_t frames = 0;
    std::int64_t damaged = 0;
    double seconds = 0;
    std::optional<std::int64_t> events;   ///< if they were searched for
    std::optional<std::string> recorded;  ///< UTC, if the container says it
    std::vector<FoundEvent> found;        ///< the events
};

/// Writes it whole or not at all. Call it once all files that it names exist.
/// \throws Error io
void write_sidecar(const std::filesystem::path& out, const Sidecar& sidecar);

/// Nothing when there is none, or when `write_sidecar` did not write it for this clip.
std::optional<Sidecar> read_sidecar(const std::filesystem::path& out, const std::string& clip);

/// The sidecar in a file, if it is one and has the path of its clip's sidecar.
/// \param file below `out`
std::optional<Sidecar> read_sidecar_file(const std::filesystem::path& out, const std::string& file);

/// What `write_sidecar` writes.
std::string format_sidecar(const Sidecar& sidecar);

/// The sidecar that a text is; nothing when `format_sidecar` did not make it.
std::optional<Sidecar> parse_sidecar(const std::string& text);

/// Takes frames, length, events and time of recording from a report of `vvr render --report`.
/// \throws Error io
void take_report(Sidecar& sidecar, const std::filesystem::path& report);

/// Removes the files that a sidecar names, then the sidecar.
/// \throws Error io
void remove_outputs(const std::filesystem::path& out, const Sidecar& sidecar);

}  // namespace vvr
