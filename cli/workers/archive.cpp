#include "cli/workers/archive.h"

#include <functional>
#include <limits>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/log.h"
#include "cli/plan/settings.h"
#include "cli/workers/archive_run.h"
#include "core/annotation/time_ticks.h"
#include "core/archive/index.h"
#include "core/archive/output_files.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/base/wall_clock.h"
#include "core/footage/recorder_names.h"

namespace vvr::workers {

namespace {

namespace fs = std::filesystem;

/// The camera and start time of a clip and their source, for people: "camera gate, 2026-11-21 20:00:00 by file name
/// (Frigate)".
/// \param clip path relative to the archive
std::string describe_name(const std::string& clip, const ArchiveJob& job) {
    const footage::RecorderName name = job.names.read(clip);
    const std::string camera = job.names.camera_of(clip);
    std::string text = camera.empty() ? "camera not known" : "camera " + shown_text(archive::text_of_path(camera));
    const auto begin =
        name.begin ? footage::utc_of(*name.begin) : archive::begin_of_clip({clip}, job.names, job.rules.day, job.in);
    if (!begin) {
        return fmt::format("{}, {}{}", text, row_of(ClockSource::none).words,
                           name.no_clock ? ": the camera did not know it either" : "");
    }
    text += ", " + annotation::format_clock(*begin + local_offset(*begin));
    if (!name.begin) return fmt::format("{} {}", text, row_of(ClockSource::container).words);
    return fmt::format("{} {} ({})", text, row_of(ClockSource::file_name).words, name.scheme);
}

// Far more than the largest picture and page need. A worker that a malicious clip has taken over can't fill the disk.
constexpr std::chrono::seconds settling_time{60};  // a file that changed within it is still being written
constexpr std::int64_t largest_file = 2'000'000'000;
constexpr std::int64_t most_written = 4'000'000'000;

/// Each worker's share of the machine.
struct Shares {
    int workers;
    int threads;  ///< per worker
    std::int64_t memory;
};

Shares split_for_threads(const ArchiveOptions& options, std::size_t clips) {
    const int threads = options.threads;
    constexpr std::int64_t usual_need = 1'000'000'000;
    constexpr std::int64_t least_limit = 2 * usual_need;
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    // The rest is for the run itself, other programs and the files that the system caches.
    const std::int64_t memory = std::min(machine_memory(), control_group_memory()) / 5 * 4;
    const int by_memory = static_cast<int>(std::clamp<std::int64_t>(memory / usual_need, 1, cores));
    int workers = options.jobs.value_or(std::max(1, std::min(by_memory, cores / std::max(1, threads))));
    workers = static_cast<int>(std::clamp<std::size_t>(clips, 1, static_cast<std::size_t>(workers)));
    return {workers, threads > 0 ? threads : std::max(1, cores / workers),
            std::min(own_memory_limit(), options.max_memory.value_or(std::max(memory / workers, least_limit)))};
}

ArchiveJob job_of(const ArchiveOptions& options, const footage::RecorderNames& names) {
    ArchiveJob job;
    job.names = names;
    job.in = options.in;
    job.out = options.out;
    for (const archive::OutputRow& row : archive::output_rows) {
        if (row.kind != archive::OutputKind::page || options.writes(Outputs::pages))
            job.rules.files.push_back(row.kind);
    }
    job.rules.version = version();
    job.rules.settle = settling_time;
    // With fewer clips a worker's share of the memory is larger.
    constexpr std::size_t many = std::numeric_limits<int>::max();
    job.rules.limits = {options.timeout.count(), split_for_threads(options, many).memory};
    job.rules.day = options.day_rule();
    job.rules.day.by_container =
        std::ranges::count(options.pictures.settings,
                           std::pair<std::string, std::string>(setting::start_time.name, "container")) > 0;
    job.rules.keep = options.keep;
    if (options.keep_events) job.pieces_margin = options.margin;
    job.pictures = options.pictures;
    job.of_cameras = options.of_cameras;
    for (const auto& [camera, pictures] : options.of_cameras) job.names.describe_camera(camera, pictures.names);
    job.drawn_with = options.drawn_with;
    return job;
}

void make_folder(const fs::path& out) {
    std::error_code error;
    fs::create_directories(out, error);
    if (error)
        throw system_error(error.value(), fmt::format("cannot create the folder '{}'", out.string()),
                           "choose another -o");
    // Permissions don't tell everything, so try to write a file. An irregular file in the index's place must not stop
    // the drawing.
    if (!archive::irregular_file_at(out / archive::index_name)) check_file_path(out / archive::index_name);
}

void print_plan(const std::vector<PlannedClip>& planned, const ArchiveJob& job) {
    for (const auto& [clip, need, reason] : planned) {
        if (need == archive::Need::nothing) continue;
        const bool failed = need == archive::Need::retry || need == archive::Need::given_up;
        const auto day = job.days.find(clip.path);
        cli::print(fmt::format("{:<15} {}{}{}\n", archive::name_of(need), shown_text(archive::text_of_path(clip.path)),
                               failed ? ": " + reason : "",
                               day == job.days.end() ? "  " + describe_name(clip.path, job) : ""));
        if (day == job.days.end()) continue;
        for (const std::string& file : day->second.files) {
            cli::print(fmt::format("{:<15}   {}  {}\n", "", shown_text(archive::text_of_path(file)),
                                   describe_name(file, job)));
        }
    }
}

std::size_t count(const std::vector<PlannedClip>& planned, archive::Need need) {
    return static_cast<std::size_t>(std::ranges::count(planned, need, &PlannedClip::need));
}

/// The clips found, and what to do with them.
struct ArchivePlan {
    std::size_t unreadable = 0;
    std::size_t clips = 0;    ///< of all shards
    std::size_t waiting = 0;  ///< clips that are in no day yet
    std::vector<PlannedClip> planned;
};

/// The outcome of the run in one line.
std::string summary_of(const ArchivePlan& found, const ArchiveOutcome& outcome, double seconds) {
    const std::vector<PlannedClip>& planned = found.planned;
    std::string text =
        outcome.drawn + outcome.failed == 0
            ? "nothing to do"
            : fmt::format("{} drawn, {} failed, {:.1f} s", counted(static_cast<std::int64_t>(outcome.drawn), "clip"),
                          outcome.failed, seconds);
    const std::pair<std::size_t, const char*> others[] = {
        {count(planned, archive::Need::nothing), "done before"},
        {count(planned, archive::Need::given_up), "failed three times"},
        {count(planned, archive::Need::still_written) + found.waiting, "still being written"},
        {count(planned, archive::Need::later), "waiting to be redrawn with more clips"},
        {count(planned, archive::Need::outside) + outcome.outside, "without a frame in the given span"},
        {count(planned, archive::Need::unread), "lacking files that can't be read"},
        {count(planned, archive::Need::expired), "older than --keep"},
        {outcome.elsewhere, "drawn by another run or deleted"}};
    const char* separator = "; ";
    for (const auto& [clips, what] : others) {
        if (clips == 0) continue;
        text += fmt::format("{}{} {}", std::exchange(separator, ", "), clips, what);
    }
    return text;
}

/// Warns about clips with a time in the future. They are drawn nevertheless.
void warn_of_wrong_clocks(const std::vector<archive::Clip>& clips, const archive::Settling& settling,
                          const ArchiveJob& job, spdlog::logger& log) {
    const auto is_ahead = [&](const archive::Clip& clip) { return settling.is_ahead(clip); };
    const auto first = std::ranges::find_if(clips, is_ahead);
    if (first == clips.end()) return;
    const auto all = std::ranges::count_if(clips, is_ahead);
    log.warn(
        "{} a modification time in the future, such as '{}'; check the clocks of the camera, the server and this "
        "machine",
        all == 1 ? "1 clip has" : fmt::format("{} clips have", all), (job.in / first->path).string());
}

void warn_of_unset_clocks(const std::vector<archive::Clip>& clips, const ArchiveJob& job, spdlog::logger& log) {
    const auto unset =
        std::ranges::count_if(clips, [&](const archive::Clip& clip) { return job.names.read(clip.path).no_clock; });
    if (unset > 0) log.warn("'{}': {}", job.in.string(), footage::text_of_unset_clocks(unset));
}

void warn_of_undated(const ArchiveJob& job, spdlog::logger& log) {
    std::vector<std::string> undated;
    for (const auto& [path, day] : job.days) undated.insert(undated.end(), day.undated.begin(), day.undated.end());
    if (undated.empty()) return;
    log.warn(
        "'{}': {} {}, for example '{}'; each is assigned to the day of its last modification, which may be wrong; "
        "describe the names with --names",
        job.in.string(), lacks_time(job.rules.day), counted(std::ssize(undated), "clip"),
        archive::text_of_path(*std::ranges::min_element(undated)));
}

/// A section of a camera that has no clips may have a wrong name.
void warn_of_unused_cameras(const std::vector<archive::Clip>& clips, const ArchiveJob& job, spdlog::logger& log) {
    if (job.of_cameras.empty() || clips.empty()) return;
    std::set<std::string> cameras;
    for (const archive::Clip& clip : clips) cameras.insert(job.names.camera_of(clip.path));
    std::vector<std::string> sections;
    for (const auto& [section, pictures] : job.of_cameras) sections.push_back(section);
    std::set<std::string> unused(sections.begin(), sections.end());
    for (const std::string& camera : cameras) unused.erase(footage::name_of_camera(camera, sections));
    cameras.erase("");
    const std::string known =
        cameras.empty() ? "no name or folder of its clips gives a camera; describe the names with --names"
                        : fmt::format("its cameras: {}", shown_text(fmt::format("{}", fmt::join(cameras, ", "))));
    for (const std::string& section : unused) {
        log.warn("the config file has a section [camera.{}], but '{}' has no clip of that camera; {}",
                 shown_text(section), job.in.string(), known);
    }
}

ArchivePlan plan_run(const ArchiveOptions& options, const archive::ClipNames& clips, ArchiveJob& job,
                     spdlog::logger& log) {
    archive::Scan scan = archive::scan_archive(job.in, job.out, clips);
    std::vector<std::string> paths;
    for (const archive::Clip& clip : scan.clips) paths.push_back(clip.path);
    job.names.compare(paths);
    ArchivePlan run;
    run.clips = scan.clips.size();
    const archive::Settling settling{std::chrono::system_clock::now(), settling_time};
    warn_of_wrong_clocks(scan.clips, settling, job, log);
    warn_of_unused_cameras(scan.clips, job, log);
    warn_of_unset_clocks(scan.clips, job, log);
    std::vector<archive::Clip> wanted;
    if (options.grouping().days) {
        archive::CameraDays grouped = archive::group_by_day(scan.clips, job.names, settling, job.rules.day, job.in);
        for (archive::CameraDay& day : grouped.days) {
            wanted.push_back(day.clip);
            job.days.emplace(day.clip.path, std::move(day));
        }
        scan.problems.insert(scan.problems.end(), grouped.problems.begin(), grouped.problems.end());
        run.waiting = grouped.waiting;
        run.clips = wanted.size() + run.waiting;
        warn_of_undated(job, log);
    } else {
        wanted = std::move(scan.clips);
    }
    for (const archive::ScanProblem& problem : scan.problems) {
        log.error("'{}': {}", (job.in / problem.path).string(), problem.reason);
    }
    if (scan.skipped > 0) {
        log.info(
            "'{}': at least {} in folders of deleted files or snapshots left out: '{}'; to draw them, give such a "
            "folder as CLIPS",
            job.in.string(), counted(static_cast<std::int64_t>(scan.skipped), "clip"),
            fmt::join(scan.system_folders, "', '"));
    }
    run.unreadable = scan.problems.size();
    std::erase_if(wanted, [&](const archive::Clip& clip) { return !options.shard.contains(clip.path); });
    run.planned = plan_archive(wanted, job);
    for (const PlannedClip& planned : run.planned) {
        if (planned.need != archive::Need::unread) continue;
        ++run.unreadable;
        log_failure(log, job, planned.clip.path, ErrorCode::partial, planned.reason);
    }
    return run;
}

/// Runs a step that follows the drawing. An error about one file is logged, so that the next step still runs.
/// \param step false = it has logged an error itself
/// \returns whether the step succeeded
bool succeeds(spdlog::logger& log, const std::function<bool()>& step) {
    try {
        return step();
    } catch (const Error& error) {
        if (!affects_one_file(error)) throw;
        cli::log_error(log, error.code(), error.what());
        return false;
    }
}

}  // namespace

cli::ExitStatus run_archive(const ArchiveOptions& options, const cli::Environment& environment) {
    ArchiveJob job = job_of(options, footage::RecorderNames(options.pictures.names, options.in));
    const archive::ClipNames clips(options.match, options.exclude, options.grouping().days);
    if (!options.draws()) {
        make_folder(options.out);
        write_index(job, clips, environment);
        if (!options.events_csv.empty() &&
            !write_events_table(job, options.grouping().days, options.events_csv, environment))
            return cli::ExitStatus::io;
        environment.log.info("'{}' is up to date", (options.out / archive::index_name).string());
        return cli::ExitStatus::done;
    }
    const auto begin = std::chrono::steady_clock::now();
    const ArchivePlan found = plan_run(options, clips, job, environment.log);
    if (found.clips == 0) {
        // Not a warning: a monitor that reads what --quiet prints must learn of a disk that is not mounted.
        environment.log.error("no clips found below '{}'; searched for {}{}", job.in.string(), clips.wanted(),
                              options.grouping().days ? "" : "; --per day draws pictures of a camera too");
    }
    if (options.dry_run) {
        print_plan(found.planned, job);
        if (options.keep) remove_expired(job, options.shard, true, environment);
        if (options.prune) prune(job, clips, options.shard, true, environment);
        return cli::ExitStatus::done;
    }
    make_folder(options.out);
    if (!options.events_csv.empty()) check_file_path(options.events_csv);
    if (options.writes(Outputs::index)) archive::check_own_index(options.out);  // before hours of drawing
    std::vector<PlannedClip> work = found.planned;
    std::erase_if(work, [](const PlannedClip& planned) { return !archive::wants_work(planned.need); });
    cli::EventFile events(options.events_to, environment.log);
    job.reports_events = !options.events_to.empty();
    ArchiveOutcome outcome;
    if (!work.empty()) {
        const Shares shares = split_for_threads(options, work.size());
        job.threads = shares.threads;
        job.limits = {options.timeout, shares.memory, largest_file, most_written};
        job.rules.limits.memory = shares.memory;
        job.sandbox = std::make_shared<const Sandbox>(options.sandbox, options.needs);
        environment.log.log(job.sandbox->is_whole() ? spdlog::level::info : spdlog::level::warn, "{}",
                            job.sandbox->summary());
        environment.log.debug("{} at a time, each with {} and {} MB", counted(shares.workers, "clip"),
                              counted(shares.threads, "thread"), shares.memory / 1'000'000);
        outcome = draw_clips(job, work, shares.workers, events, environment);
    }
    // Write the index even if pruning failed.
    const bool pruned = !options.prune ||
                        succeeds(environment.log, [&] { return prune(job, clips, options.shard, false, environment); });
    const bool aged = !options.keep ||
                      succeeds(environment.log, [&] { return remove_expired(job, options.shard, false, environment); });
    const bool indexed = !options.writes(Outputs::index) || succeeds(environment.log, [&] {
        write_index(job, clips, environment);
        return true;
    });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    environment.log.info("'{}': {}", options.out.string(), summary_of(found, outcome, took.count()));
    const bool listed = options.events_csv.empty() || succeeds(environment.log, [&] {
                            return write_events_table(job, options.grouping().days, options.events_csv, environment);
                        });
    const bool reported = events.finish();
    if (!pruned || !aged || !indexed || !listed || !reported) return cli::ExitStatus::io;
    return outcome.failed + outcome.not_whole + found.unreadable > 0 ? cli::ExitStatus::partial : cli::ExitStatus::done;
}

}  // namespace vvr::workers
