#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/log.h"
#include "cli/workers/archive_run.h"
#include "core/archive/output_files.h"
#include "core/archive/prune.h"

namespace vvr::workers {

namespace {

/// Removes the files of a clip, or prints that it would.
/// \param word for the list of a dry run
/// \param why for the log; the names of the files follow
///
/// \returns false after an error about these files, which it logs
bool remove_files_of(const archive::Sidecar& sidecar, const ArchiveJob& job, std::string_view word,
                     std::string_view why, bool dry_run, const cli::Environment& environment) {
    const std::string name = archive::text_of_path(sidecar.clip.path);
    if (dry_run) {
        cli::print(fmt::format("{:<15} {}\n", word, name));
        return true;
    }
    try {
        const auto held = environment.signals.hold();
        const auto removed = archive::remove_clip(job.out, job.in, sidecar);
        if (!removed) return true;  // another run is drawing it, or just has
        environment.log.info("{}: {} {}", name, why,
                             archive::text_of_path(fmt::format("{}", fmt::join(*removed, ", "))));
        return true;
    } catch (const Error& error) {
        if (!affects_one_file(error)) throw;
        cli::log_error(environment.log, error.code(), error.what());
        return false;
    }
}

/// The sidecars of a part of the clips, for a removal.
/// \param all out: false if there may be more, which an error line says
std::vector<archive::Sidecar> list_sidecars(const ArchiveJob& job, const archive::Shard& shard, bool& all,
                                            const cli::Environment& environment) {
    archive::Outputs outputs = archive::list_outputs(job.out, job.in);
    for (const archive::ScanProblem& problem : outputs.problems) {
        if (!problem.unread) continue;
        all = false;
        cli::log_error(environment.log, ErrorCode::io,
                       fmt::format("cannot read '{}': {}; nothing is removed there; fix its permissions",
                                   (job.out / problem.path).string(), problem.reason));
    }
    std::erase_if(outputs.sidecars, [&](const auto& sidecar) { return !shard.contains(sidecar.clip.path); });
    return std::move(outputs.sidecars);
}

}  // namespace

bool prune(const ArchiveJob& job, const archive::ClipNames& clips, const archive::Shard& shard, bool dry_run,
           const cli::Environment& environment) {
    bool all = true;
    const std::vector<archive::Sidecar> sidecars = list_sidecars(job, shard, all, environment);
    if (sidecars.empty()) return all;
    const archive::Present present = archive::find_present(job.in, job.out, clips, job.names, sidecars);
    archive::check_can_prune(job.in, present);
    std::set<std::string> away;
    std::size_t unknown = 0;
    for (const archive::Sidecar& sidecar : sidecars) {
        // Check right before the removal: a disk may have been unmounted since the last one.
        const archive::SourceStatus verdict = archive::source_state_of(job.in, sidecar, present, job.names);
        if (verdict.fate == archive::SourceState::away) away.insert(verdict.folder);
        if (verdict.fate == archive::SourceState::unknown) ++unknown;
        const bool moved = verdict.fate == archive::SourceState::moved;
        if (verdict.fate != archive::SourceState::gone && !moved) continue;
        all &= remove_files_of(sidecar, job, moved ? "moved" : "gone",
                               moved ? "its clips belong to other days now, so its picture was removed:"
                                     : "the clip was deleted, so its picture was removed:",
                               dry_run, environment);
    }
    for (const std::string& folder : away) {
        environment.log.warn(
            "'{}' is empty or missing, so its pictures are kept: its disk may not be mounted; if the clips were "
            "deleted, remove the pictures yourself",
            (job.in / folder).string());
    }
    if (unknown > 0) {
        environment.log.warn(
            "{} drawn by an older vvr, which did not record the clips, so the pictures are kept; if the clips were "
            "deleted, remove the pictures yourself",
            unknown == 1 ? "1 day was" : fmt::format("{} days were", unknown));
    }
    return all;
}

bool remove_expired(const ArchiveJob& job, const archive::Shard& shard, bool dry_run,
                    const cli::Environment& environment) {
    const auto now = std::chrono::system_clock::now();
    bool all = true;
    for (const archive::Sidecar& sidecar : list_sidecars(job, shard, all, environment)) {
        if (!archive::is_expired(sidecar.clip, job.rules, now)) continue;
        all &= remove_files_of(sidecar, job, archive::name_of(archive::Need::expired), "older than --keep; removed",
                               dry_run, environment);
    }
    return all;
}

}  // namespace vvr::workers
