#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cli/console.h"
#include "cli/workers/archive_clip.h"
#include "core/archive/clips.h"
#include "core/video/recorder_names.h"

namespace vvr::workers {

/// A clip, and what is to become of it.
struct PlannedClip {
    archive::Clip clip;
    archive::Need need;
    std::string reason;  ///< why it failed, where it did
};

/// What is to become of each clip, the newest first.
std::vector<PlannedClip> plan_archive(const std::vector<archive::Clip>& clips, const ArchiveJob& job);

/// What came of a run.
struct ArchiveOutcome {
    std::size_t drawn = 0;
    std::size_t failed = 0;
    std::size_t not_whole = 0;  ///< drawn, without some of its files
    std::size_t elsewhere = 0;  ///< in the hands of another run, or gone
};

/// Draws those clips, some at a time.
/// \throws Error when something other than a clip is at fault, a full disk for one; then the rest is not tried
ArchiveOutcome draw_clips(const ArchiveJob& job, const std::vector<PlannedClip>& clips, int workers,
                          const cli::Environment& environment);

/// Writes the index from the sidecars, unless it stands there as it should, and removes what killed runs left.
void write_index(const ArchiveJob& job, const cli::Environment& environment);

/// What is to become of each day of a camera, the newest first.
std::vector<PlannedClip> plan_days(const ArchiveJob& job);

/// Removes the files of clips that have gone for certain, and of days of which each clip has.
/// \param clips of the run: what it leaves out of them is there all the same
/// \returns how many there were
/// \throws Error io when nobody can know what has gone
std::size_t prune(const ArchiveJob& job, const archive::ClipNames& clips, const archive::Shard& shard, bool dry_run,
                  const cli::Environment& environment);

}  // namespace vvr::workers
