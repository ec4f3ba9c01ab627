#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/archive/names.h"
#include "core/archive/scan.h"

namespace vvr {

/// What an archive knows of a clip: the file beside its picture, and all that there is of a database.
struct Sidecar {
    enum class State { done, failed };

    Clip clip;             ///< as it was when it was read
    std::string settings;  ///< digest of what makes its files what they are
    std::string version;   ///< of the vvr that made them
    State state = State::done;
    int tries = 1;
    int status = 0;      ///< exit status of the last try
    std::string reason;  ///< why it failed
    std::vector<OutputKind> files;
    double took = 0;  ///< seconds that the last try took

    // Of what is done.
    std::int64_t frames = 0;
    std::int64_t damaged = 0;
    double seconds = 0;
    std::optional<std::int64_t> events;   ///< where they were looked for
    std::optional<std::string> recorded;  ///< UTC, where the container tells
};

/// Written whole or not at all, once everything it speaks of is there.
/// \throws Error io
void write_sidecar(const std::filesystem::path& out, const Sidecar& sidecar);

/// Nothing where there is none, or what is there was not written for this clip by `write_sidecar`.
std::optional<Sidecar> read_sidecar(const std::filesystem::path& out, const std::string& clip);

/// The sidecar in a file, if it is one and stands where its clip's belongs.
/// \param file below `out`
std::optional<Sidecar> read_sidecar_file(const std::filesystem::path& out, const std::string& file);

/// What `write_sidecar` writes.
std::string format_sidecar(const Sidecar& sidecar);

/// Frames, length, events and time of recording, out of what `vvr render --report` wrote.
/// \throws Error io
void take_report(Sidecar& sidecar, const std::filesystem::path& report);

/// Removes what a sidecar names, itself last.
/// \throws Error io
void remove_outputs(const std::filesystem::path& out, const Sidecar& sidecar);

}  // namespace vvr
