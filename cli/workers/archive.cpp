#include "cli/workers/archive.h"

#include <algorithm>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "cli/print.h"
#include "cli/workers/archive_run.h"
#include "core/archive/names.h"
#include "core/error.h"
#include "core/image/atomic_file.h"
#include "core/machine_memory.h"
#include "core/version.h"
#include "core/words.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

/// How the machine is shared out among workers.
struct Shares {
    int workers;
    int threads;  ///< per worker
    std::int64_t memory;
};

Shares share_out(const ArchiveOptions& options, std::size_t clips) {
    const int threads = options.threads;
    constexpr std::int64_t usual_need = 1'000'000'000;
    constexpr std::int64_t least_limit = 2 * usual_need;
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const std::int64_t memory = machine_memory();
    const int by_memory = static_cast<int>(std::clamp<std::int64_t>(memory / usual_need, 1, cores));
    int workers = options.jobs.value_or(std::max(1, std::min(by_memory, cores / std::max(1, threads))));
    workers = static_cast<int>(std::clamp<std::size_t>(clips, 1, static_cast<std::size_t>(workers)));
    return {workers, threads > 0 ? threads : std::max(1, cores / workers),
            options.max_memory.value_or(std::max(memory / workers, least_limit))};
}

ArchiveJob job_of(const ArchiveOptions& options) {
    ArchiveJob job;
    job.in = options.in;
    job.out = options.out;
    for (const OutputRow& row : output_rows) {
        if (row.kind != OutputKind::page || !options.no_pages) job.rules.files.push_back(row.kind);
    }
    job.rules.settings = options.settings;
    job.rules.version = version();
    job.rules.tries = options.tries;
    job.rules.settle = options.settle;
    job.rules.redraw = options.redraw;
    job.options = options.worker_options;
    return job;
}

void make_folder(const fs::path& out) {
    std::error_code error;
    fs::create_directories(out, error);
    if (error) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot make the folder '{}': {}; choose another -o", out.string(), error.message()));
    }
    check_file_path(out / index_name);
}

void print_plan(const std::vector<PlannedClip>& planned) {
    for (const auto& [clip, need, reason] : planned) {
        if (need == Need::nothing) continue;
        print(fmt::format("{:<15} {}{}\n", name_of(need), text_of_path(clip.path),
                          need == Need::retry || need == Need::given_up ? ": " + reason : ""));
    }
}

std::size_t count(const std::vector<PlannedClip>& planned, Need need) {
    return static_cast<std::size_t>(std::ranges::count(planned, need, &PlannedClip::need));
}

/// What came of all clips, in a line.
std::string summary_of(const std::vector<PlannedClip>& planned, const ArchiveOutcome& outcome, double seconds) {
    std::string text =
        outcome.drawn + outcome.failed == 0
            ? "nothing to do"
            : fmt::format("{} drawn, {} failed, {:.1f} s", counted(static_cast<std::int64_t>(outcome.drawn), "clip"),
                          outcome.failed, seconds);
    const std::pair<std::size_t, const char*> others[] = {
        {count(planned, Need::nothing), "done before"},
        {count(planned, Need::given_up), "failed too often (--tries)"},
        {count(planned, Need::still_written), "still being written (--settle)"},
        {count(planned, Need::later), "with more clips by now (--redraw)"},
        {outcome.elsewhere, "left to another run or gone"}};
    const char* separator = "; ";
    for (const auto& [clips, what] : others) {
        if (clips == 0) continue;
        text += fmt::format("{}{} {}", std::exchange(separator, ", "), clips, what);
    }
    return text;
}

/// The clips, and what is to become of them.
struct Survey {
    std::size_t clips_there = 0;  ///< of all shares
    std::size_t unreadable = 0;
    std::vector<PlannedClip> planned;
};

Survey survey(const ArchiveOptions& options, const RecorderNames& names, ArchiveJob& job, spdlog::logger& log) {
    Scan scan = scan_archive(job.in, job.out, ClipNames(options.match, options.exclude));
    std::vector<PlannedClip> days;
    // Days are grouped for every run: else it would prune those of another.
    const auto settled = std::chrono::system_clock::now() - options.settle;
    const std::int64_t before = std::chrono::nanoseconds(settled.time_since_epoch()).count();
    std::vector<ScanProblem> ungrouped;
    for (CameraDay& day : group_by_day(scan.clips, names, before, ungrouped)) {
        if (!options.shard.holds(day.clip.path)) continue;
        std::string path = day.clip.path;
        job.days.emplace(std::move(path), std::move(day));
    }
    if (options.per != Grouping::clip) {
        days = plan_days(job);
        scan.problems.insert(scan.problems.end(), ungrouped.begin(), ungrouped.end());
    }
    for (const ScanProblem& problem : scan.problems) {
        log.error("'{}': {}", (job.in / problem.path).string(), problem.reason);
    }
    Survey survey{scan.clips.size(), scan.problems.size(), {}};
    std::erase_if(scan.clips, [&](const Clip& clip) { return !options.shard.holds(clip.path); });
    if (options.per != Grouping::day) survey.planned = plan_archive(scan.clips, job);
    survey.planned.insert(survey.planned.end(), days.begin(), days.end());
    return survey;
}

}  // namespace

ExitStatus run_archive(const ArchiveOptions& options, const Environment& environment) {
    ArchiveJob job = job_of(options);
    const RecorderNames names(options.names);
    if (options.index_only) {
        make_folder(options.out);
        write_index(job, names, environment);
        environment.log.info("'{}' is up to date", (options.out / index_name).string());
        return ExitStatus::done;
    }
    const auto begin = std::chrono::steady_clock::now();
    const Survey found = survey(options, names, job, environment.log);
    if (options.dry_run) {
        print_plan(found.planned);
        if (options.prune) prune(job, options.shard, found.clips_there, true, environment);
        return ExitStatus::done;
    }
    make_folder(options.out);
    std::vector<PlannedClip> work = found.planned;
    std::erase_if(work, [](const PlannedClip& planned) { return !wants_work(planned.need); });
    ArchiveOutcome outcome;
    if (!work.empty()) {
        const Shares shares = share_out(options, work.size());
        job.threads = shares.threads;
        job.limits = {options.timeout, shares.memory};
        job.sandbox = std::make_shared<const Sandbox>(options.sandbox, options.needs);
        environment.log.log(job.sandbox->is_whole() ? spdlog::level::info : spdlog::level::warn, "{}",
                            job.sandbox->summary());
        environment.log.debug("{} at a time, {} each, {} MB each", counted(shares.workers, "clip"),
                              counted(shares.threads, "thread"), shares.memory / 1'000'000);
        outcome = draw_clips(job, work, shares.workers, environment);
    }
    if (options.prune) prune(job, options.shard, found.clips_there, false, environment);
    if (!options.no_index) write_index(job, names, environment);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    environment.log.info("'{}': {}", options.out.string(), summary_of(found.planned, outcome, took.count()));
    const bool partial = outcome.failed + found.unreadable + count(found.planned, Need::given_up) > 0;
    return partial ? ExitStatus::partial : ExitStatus::done;
}

}  // namespace vvr
