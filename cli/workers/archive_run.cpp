#include "cli/workers/archive_run.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/log.h"
#include "cli/workers/archive_progress.h"
#include "cli/workers/worker.h"
#include "cli/workers/worker_end.h"
#include "core/archive/event_lines.h"
#include "core/archive/index.h"
#include "core/archive/output_files.h"
#include "core/archive/prune.h"
#include "core/base/atomic_file.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/tracking/event_line.h"

namespace vvr::workers {

namespace {

namespace fs = std::filesystem;

/// What a line of a log in JSON says of a clip besides.
std::string members_of(const ArchiveJob& job, const std::string& clip) {
    return json_text(
        {{"camera", or_null(archive::text_of_path(job.camera_of(clip)))}, {"clip", archive::text_of_path(clip)}});
}

/// Counts the clips of a run and logs what happened to each.
class ClipTally {
  public:
    ClipTally(std::size_t clips, const ArchiveJob& job, spdlog::logger& log) : clips_(clips), job_(job), log_(log) {}

    /// \param warnings from the worker
    void add(const archive::Sidecar& sidecar, const std::vector<std::string>& warnings) {
        const std::string name = archive::text_of_path(sidecar.clip.path);
        if (sidecar.state == archive::Sidecar::State::outside) {
            ++outcome_.outside;
            log_.debug("{} {}: {}", next(), name, sidecar.reason);
            return;
        }
        if (sidecar.state == archive::Sidecar::State::failed) {
            fail(sidecar.clip.path, sidecar.code.value_or(ErrorCode::bug),
                 fmt::format("status {}: {}{}", sidecar.status, sidecar.reason,
                             sidecar.shows ? "; the older picture is kept" : ""));
            return;
        }
        ++outcome_.drawn;
        const std::string events = sidecar.events ? counted(*sidecar.events, "event") + ", " : "";
        log_.info("{} {}: {}{:.1f} s", next(), name, events, sidecar.took);
        if (sidecar.status == 0) {
            // A day's reason already has the problems of its clips.
            if (!sidecar.reason.empty()) log_.warn("{}: {}", name, sidecar.reason);
            for (const std::string& warning : sidecar.reason.empty() ? warnings : std::vector<std::string>())
                log_.info("{}: {}", name, warning);
            return;
        }
        ++outcome_.not_whole;
        log_failure(log_, job_, sidecar.clip.path, sidecar.code.value_or(ErrorCode::partial), sidecar.reason);
    }

    void fail(const std::string& clip, ErrorCode code, const std::string& reason) {
        ++outcome_.failed;
        cli::log_error(log_, code, fmt::format("{} {} failed, {}", next(), archive::text_of_path(clip), reason),
                       members_of(job_, clip));
    }

    void skip(const std::string& clip) {
        ++outcome_.elsewhere;
        log_.debug("{} {}: skipped, because another run draws it or it was deleted", next(),
                   archive::text_of_path(clip));
    }

    const ArchiveOutcome& outcome() const { return outcome_; }

  private:
    std::string next() { return fmt::format("{}/{}", ++logged_, clips_); }

    std::size_t clips_;
    const ArchiveJob& job_;
    spdlog::logger& log_;
    std::size_t logged_ = 0;
    ArchiveOutcome outcome_;
};

/// Takes a clip. If it can't be read, or its files can't be locked, it has failed, and no sidecar says so.
std::optional<ClipTask> begin_task(const ArchiveJob& job, const std::string& clip, ClipTally& tally) {
    try {
        auto task = ClipTask::take(job, clip);
        if (!task) tally.skip(clip);
        return task;
    } catch (const Error& error) {
        if (error.code() == ErrorCode::disk_full) throw;
        tally.fail(clip, error.code(), error.what());
        return std::nullopt;
    }
}

/// Finishes a clip. If its results can't be read or written, the clip has failed and the others go on.
/// \throws Error for a full disk, or anything else that is not about this clip's files
std::optional<archive::Sidecar> finish_task(ClipTask& task, const std::string& clip, const WorkerResult& end,
                                            ClipTally& tally, cli::Signals& signals) {
    try {
        return task.finish(end, signals);
    } catch (const Error& error) {
        if (!affects_one_file(error)) throw;
        tally.fail(clip, error.code(), error.what());
        return std::nullopt;
    }
}

bool holds(const fs::path& path, const std::string& text) {
    std::error_code none;
    return fs::file_size(path, none) == text.size() && archive::read_own(path, "", text.size()).text == text;
}

/// Leaves an unchanged file alone, so that programs that have it open see no change. Throws if the path is not a
/// regular file.
void put_file(const fs::path& path, const std::string& text, cli::Signals& signals) {
    archive::check_own_place(path);
    if (holds(path, text)) return;
    const auto held = signals.hold();
    replace_link(path, std::as_bytes(std::span(text)));
}

/// The clips that certainly no longer exist, as `prune` judges it. None if that can't be known.
std::set<std::string> gone_of(const ArchiveJob& job, const archive::ClipNames& clips,
                              const std::vector<archive::Sidecar>& sidecars) {
    const auto may_be_gone = [&](const archive::Sidecar& sidecar) {
        return !sidecar.day && archive::is_gone(job.in / sidecar.clip.path);
    };
    // The other clips are looked at only where one is missing, because that takes long.
    if (job.in.empty() || std::ranges::none_of(sidecars, may_be_gone)) return {};
    try {
        const archive::Present present = archive::find_present(job.in, job.out, clips, job.names);
        archive::check_can_prune(job.in, present);
        std::set<std::string> gone;
        for (const archive::Sidecar& sidecar : sidecars) {
            if (!may_be_gone(sidecar)) continue;
            const archive::SourceStatus status = archive::source_state_of(job.in, sidecar, present, job.names);
            if (status.fate == archive::SourceState::gone) gone.insert(sidecar.clip.path);
        }
        return gone;
    } catch (const Error&) {
        return {};  // the index is useful without the marks
    }
}

/// The rules by which the names of these clips tell their cameras.
footage::RecorderNames names_for(const ArchiveJob& job, const std::vector<archive::Sidecar>& sidecars) {
    std::vector<std::string> clips;
    for (const archive::Sidecar& sidecar : sidecars) {
        if (!sidecar.day) clips.push_back(sidecar.clip.path);
    }
    footage::RecorderNames names = job.names;
    names.compare(clips);
    return names;
}

/// Removes files of days that have no clip left.
void remove_other_days(const fs::path& out, const archive::DayFiles& days) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
        const std::string name = entry.path().filename().string();
        std::error_code none;
        if (archive::is_day_file(name) && !days.contains(name)) archive::remove_own(entry.path(), none);
    }
}

}  // namespace

void log_failure(spdlog::logger& log, const ArchiveJob& job, const std::string& clip, ErrorCode code,
                 std::string_view text) {
    cli::log_error(log, code, fmt::format("{}: {}", archive::text_of_path(clip), text), members_of(job, clip));
}

std::vector<PlannedClip> plan_archive(const std::vector<archive::Clip>& clips, const ArchiveJob& job) {
    std::vector<PlannedClip> planned;
    planned.reserve(clips.size());
    for (const archive::Clip& clip : clips) {
        const std::optional<archive::Sidecar> sidecar = archive::read_sidecar(job.out, clip.path);
        planned.push_back({clip, job.need_of(clip, sidecar), sidecar ? sidecar->reason : ""});
    }
    // People want to see the latest clips first.
    std::ranges::stable_sort(planned, std::greater(),
                             [](const PlannedClip& planned_clip) { return planned_clip.clip.modified; });
    return planned;
}

namespace {

/// Draws the clips of a run with a pool of workers. If a worker reports an OpenGL error, the clip may be the cause. A
/// second worker that reads no clip then tests OpenGL, and the failed clips wait for its result.
class Drawing {
  public:
    Drawing(const ArchiveJob& job, const std::vector<PlannedClip>& clips, int workers, cli::EventFile& events,
            const cli::Environment& environment)
        : job_(job),
          events_(events),
          environment_(environment),
          tally_(clips.size(), job, environment.log),
          bar_(environment),
          pool_(workers, environment.signals) {
        progress_.clips = clips.size();
        for (const PlannedClip& planned : clips) progress_.bytes += planned.clip.size;
        if (bar_.is_shown()) pool_.set_tick([this] { show_progress(); });
    }

    void draw(const archive::Clip& clip) {
        pool_.wait_for_room();
        bar_.clear();
        std::optional<ClipTask> task = begin_task(job_, clip.path, tally_);
        if (!task) return end_progress(clip.size);
        std::unique_ptr<Worker> worker = task->start();
        running_.push_back({worker.get(), clip.path, clip.size});
        pool_.add(std::move(worker), [this, task = std::make_shared<ClipTask>(std::move(*task)), clip,
                                      drawn = running_.back().worker](const WorkerResult& end) {
            std::erase_if(running_, [drawn](const Running& one) { return one.worker == drawn; });
            end_progress(clip.size);
            bar_.clear();
            take({task, clip.path, end});
        });
    }

    ArchiveOutcome wait_for_all() {
        pool_.wait_for_all();
        return tally_.outcome();
    }

  private:
    struct Running {
        const Worker* worker;
        std::string clip;
        std::int64_t bytes;
    };

    void end_progress(std::int64_t bytes) {
        ++progress_.finished;
        progress_.finished_bytes += bytes;
    }

    void show_progress() {
        std::vector<ClipProgress> clips;
        for (const Running& one : running_) clips.push_back({one.clip, one.bytes, one.worker->progress()});
        bar_.show(progress_, clips);
    }

    struct Drawn {
        std::shared_ptr<ClipTask> task;
        std::string clip;
        WorkerResult end;
    };

    void take(Drawn drawn) {
        if (!opengl_failed(drawn.end) || can_draw_ || tally_.outcome().drawn > 0) {
            finish(drawn);
            return;
        }
        undecided_.push_back(std::move(drawn));
        if (undecided_.size() > 1) return;
        pool_.add(start_drawing_test(job_), [this](const WorkerResult& end) { take_test(end); });
    }

    void take_test(const WorkerResult& end) {
        const std::vector<Drawn> undecided = std::exchange(undecided_, {});
        if (end.status != 0) {
            const std::string words = error_text_of(end);
            const ErrorCode code = opengl_failed(end) ? code_of(end) : ErrorCode::opengl_unavailable;
            throw Error(code, fmt::format("no clip can be drawn, so this run ends: {}",
                                          words.empty() ? "OpenGL does not start" : words));
        }
        can_draw_ = true;
        for (const Drawn& drawn : undecided) finish(drawn);
    }

    void finish(const Drawn& drawn) {
        const auto sidecar = finish_task(*drawn.task, drawn.clip, drawn.end, tally_, environment_.signals);
        if (!sidecar) return;
        tally_.add(*sidecar, drawn.end.message.warnings);
        const auto held = environment_.signals.hold();
        for (const tracking::EventLine& line : drawn.task->new_events()) events_.add(line);
    }

    const ArchiveJob& job_;
    cli::EventFile& events_;
    const cli::Environment& environment_;
    ClipTally tally_;
    ArchiveBar bar_;
    ArchiveProgress progress_{};
    std::vector<Running> running_{};
    bool can_draw_ = false;
    std::vector<Drawn> undecided_{};
    WorkerPool pool_;
};

}  // namespace

ArchiveOutcome draw_clips(const ArchiveJob& job, const std::vector<PlannedClip>& clips, int workers,
                          cli::EventFile& events, const cli::Environment& environment) {
    Drawing drawing(job, clips, workers, events, environment);
    for (const PlannedClip& planned : clips) drawing.draw(planned.clip);
    return drawing.wait_for_all();
}

void write_index(const ArchiveJob& job, const archive::ClipNames& clip_names, const cli::Environment& environment) {
    archive::check_own_index(job.out);
    // If two runs end at the same time, the second must read what the first wrote.
    const std::vector<std::string> files{std::string(archive::index_name)};
    const LockFile claim = LockFile::wait_for(job.out, files.front());
    if (claim.is_stale()) remove_leftovers(job.out, files);
    archive::Outputs outputs = archive::list_outputs(job.out, job.in);
    for (const archive::ScanProblem& problem : outputs.problems) {
        environment.log.warn("'{}': {}; it is left unchanged and is missing from the index",
                             (job.out / problem.path).string(), problem.reason);
    }
    archive::tidy(job.out, outputs);
    std::erase_if(outputs.sidecars, [](const auto& one) { return one.state == archive::Sidecar::State::outside; });
    const footage::RecorderNames names = names_for(job, outputs.sidecars);
    const archive::DayFiles days = archive::make_day_files(outputs.sidecars, names);
    for (const auto& [name, text] : days) {
        try {
            put_file(job.out / name, text, environment.signals);
        } catch (const Error& error) {
            if (!affects_one_file(error)) throw;
            // The index is useful without the events of one day.
            cli::log_error(environment.log, error.code(), error.what());
        }
    }
    put_file(job.out / archive::index_name,
             archive::make_index(outputs.sidecars, names, gone_of(job, clip_names, outputs.sidecars)),
             environment.signals);
    remove_other_days(job.out, days);
}

bool write_events_table(const ArchiveJob& job, bool days, const fs::path& table, const cli::Environment& environment) {
    bool all = true;
    std::string text = tracking::events_table_heading();
    const archive::Outputs outputs = archive::list_outputs(job.out, job.in);
    const footage::RecorderNames names = names_for(job, outputs.sidecars);
    for (const archive::Sidecar& sidecar : outputs.sidecars) {
        if (sidecar.day.has_value() != days || sidecar.files.empty()) continue;
        try {
            text += archive::table_lines_of(job.out, sidecar, names);
        } catch (const Error& error) {
            log_failure(environment.log, job, sidecar.clip.path, error.code(), error.what());
            all = false;
        }
    }
    const auto held = environment.signals.hold();
    replace_file(table, std::as_bytes(std::span(text)));
    return all;
}

}  // namespace vvr::workers
