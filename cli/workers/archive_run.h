#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/event_file.h"
#include "cli/workers/archive_clip.h"
#include "core/archive/clips.h"
#include "core/footage/recorder_names.h"

namespace vvr::workers {

/// A clip and what to do with it.
struct PlannedClip {
    archive::Clip clip;
    archive::Need need;
    std::string reason;  ///< why it failed last time, if it did
};

/// Decides what to do with each clip or day, newest first.
std::vector<PlannedClip> plan_archive(const std::vector<archive::Clip>& clips, const ArchiveJob& job);

/// Logs that a clip or a day has failed.
void log_failure(spdlog::logger& log, const ArchiveJob& job, const std::string& clip, ErrorCode code,
                 std::string_view text);

/// The counts of a run.
struct ArchiveOutcome {
    std::size_t drawn = 0;
    std::size_t failed = 0;
    std::size_t not_whole = 0;  ///< drawn, but without some of its files or without pieces of some events
    std::size_t outside = 0;    ///< without a frame in the span that is drawn
    std::size_t elsewhere = 0;  ///< another run has them, or they no longer exist
};

/// Draws the clips, several at a time.
/// \throws Error when the cause is not a clip, such as a full disk; the rest is then not tried
/// \param events where new events are written
ArchiveOutcome draw_clips(const ArchiveJob& job, const std::vector<PlannedClip>& clips, int workers,
                          cli::EventFile& events, const cli::Environment& environment);

/// Writes the index from the sidecars if it has changed, and removes what killed runs left behind.
/// \param clip_names which files are clips; see `prune`
void write_index(const ArchiveJob& job, const archive::ClipNames& clip_names, const cli::Environment& environment);

/// Writes a table of the events of all clips, or of all days, from their reports: a line for each event, and one for
/// each without events.
/// \returns false if a report can't be read; an error line says which
/// \throws Error io
bool write_events_table(const ArchiveJob& job, bool days, const std::filesystem::path& table,
                        const cli::Environment& environment);

/// Removes the files of clips that are certainly gone, and of days all of whose clips are gone.
/// \param clips which files are clips; an excluded file counts as present
/// \returns false if some files could not be removed; an error line says which
/// \throws Error io when it can't be known what is gone, or for a full disk
bool prune(const ArchiveJob& job, const archive::ClipNames& clips, const archive::Shard& shard, bool dry_run,
           const cli::Environment& environment);

/// Removes the files of clips and days that are older than files are kept: only those that a sidecar names.
/// \returns false if some files could not be removed; an error line says which
/// \throws Error io
bool remove_expired(const ArchiveJob& job, const archive::Shard& shard, bool dry_run,
                    const cli::Environment& environment);

}  // namespace vvr::workers
