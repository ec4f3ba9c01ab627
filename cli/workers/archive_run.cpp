#include "cli/workers/archive_run.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "cli/print.h"
#include "cli/workers/pool.h"
#include "core/archive/index.h"
#include "core/archive/prune.h"
#include "core/image/atomic_file.h"
#include "core/read_file.h"
#include "core/words.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

/// So many clips that can't be drawn, and none that can, are the machine's fault.
constexpr std::size_t enough_undrawn = 3;

/// Says what becomes of the clips of a run, one after another.
class Account {
  public:
    Account(std::size_t clips, spdlog::logger& log) : clips_(clips), log_(log) {}

    void add(const Sidecar& sidecar) {
        const std::string name = text_of_path(sidecar.clip.path);
        if (sidecar.state == Sidecar::State::failed) {
            fail(sidecar.clip.path, fmt::format("status {}: {}", sidecar.status, sidecar.reason));
            return;
        }
        ++outcome_.drawn;
        const std::string events = sidecar.events ? counted(*sidecar.events, "event") + ", " : "";
        log_.info("{} {}: {}{:.1f} s", next(), name, events, sidecar.took);
    }

    void fail(const std::string& clip, const std::string& reason) {
        ++outcome_.failed;
        log_.error("{} {} failed, {}", next(), text_of_path(clip), reason);
    }

    void pass_over(const std::string& clip) {
        ++outcome_.elsewhere;
        log_.debug("{} {}: another run has it, or it has gone", next(), text_of_path(clip));
    }

    const ArchiveOutcome& outcome() const { return outcome_; }

  private:
    std::string next() { return fmt::format("{}/{}", ++told_, clips_); }

    std::size_t clips_;
    spdlog::logger& log_;
    std::size_t told_ = 0;
    ArchiveOutcome outcome_;
};

/// A clip's turn, unless its place is taken: then the clip has failed, but there is nowhere to write that down.
std::optional<ClipTurn> take_turn(const ArchiveJob& job, const std::string& clip, Account& account) {
    try {
        auto turn = ClipTurn::take(job, clip);
        if (!turn) account.pass_over(clip);
        return turn;
    } catch (const Error& error) {
        if (is_disk_full(error.what())) throw;
        account.fail(clip, error.what());
        return std::nullopt;
    }
}

/// What came of a clip, unless that can't be read or written down: then the clip has failed, and the others go on. A
/// full disk, and what is no matter of this clip's files, is an error still.
std::optional<Sidecar> finish_turn(ClipTurn& turn, const std::string& clip, const WorkerEnd& end, bool counts,
                                   Account& account) {
    try {
        return turn.finish(end, counts);
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::io || is_disk_full(error.what())) throw;
        account.fail(clip, error.what());
        return std::nullopt;
    }
}

bool holds(const fs::path& path, const std::string& text) {
    std::error_code none;
    return fs::is_regular_file(path, none) && read_file(path.string()) == text;
}

/// Leaves a file alone that is as it should be: who keeps it open sees no change.
void put_file(const fs::path& path, const std::string& text) {
    if (!holds(path, text)) replace_file(path, std::as_bytes(std::span(text)));
}

/// The clips that are no longer there; none where their folder itself is not, as its disk may not be mounted.
std::set<std::string> gone_of(const fs::path& in, const std::vector<Sidecar>& sidecars) {
    std::set<std::string> gone;
    std::error_code none;
    if (in.empty() || !fs::is_directory(in, none) || fs::is_empty(in, none)) return gone;
    for (const Sidecar& sidecar : sidecars) {
        if (!sidecar.day && is_gone(in / sidecar.clip.path)) gone.insert(sidecar.clip.path);
    }
    return gone;
}

/// Files of days on which no clip is left.
void remove_other_days(const fs::path& out, const DayFiles& days) {
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(out, error)) {
        const std::string name = entry.path().filename().string();
        std::error_code none;
        const bool is_file = fs::is_regular_file(fs::symlink_status(entry.path(), none));
        if (is_file && is_day_file(name) && !days.contains(name)) fs::remove(entry.path(), none);
    }
}

}  // namespace

std::vector<PlannedClip> plan_archive(const std::vector<Clip>& clips, const ArchiveJob& job) {
    const auto now = std::chrono::system_clock::now();
    std::vector<PlannedClip> planned;
    planned.reserve(clips.size());
    for (const Clip& clip : clips) {
        const std::optional<Sidecar> sidecar = read_sidecar(job.out, clip.path);
        planned.push_back({clip, need_of(clip, sidecar, job.out, job.rules, now), sidecar ? sidecar->reason : ""});
    }
    // What has just happened is what people want to see.
    std::ranges::stable_sort(planned, std::greater(),
                             [](const PlannedClip& planned_clip) { return planned_clip.clip.modified; });
    return planned;
}

std::vector<PlannedClip> plan_days(const ArchiveJob& job) {
    const auto now = std::chrono::system_clock::now();
    std::vector<PlannedClip> planned;
    for (const auto& [path, day] : job.days) {
        const std::optional<Sidecar> sidecar = read_sidecar(job.out, path);
        planned.push_back(
            {day.clip, need_of_day(day.clip, sidecar, job.out, job.rules, now), sidecar ? sidecar->reason : ""});
    }
    std::ranges::stable_sort(planned, std::greater(),
                             [](const PlannedClip& planned_day) { return planned_day.clip.modified; });
    return planned;
}

ArchiveOutcome draw_clips(const ArchiveJob& job, const std::vector<PlannedClip>& clips, int workers,
                          const Environment& environment) {
    Account account(clips.size(), environment.log);
    std::size_t undrawn = 0;
    WorkerPool pool(workers, environment.signals);
    for (const PlannedClip& planned : clips) {
        pool.wait_for_room();
        std::optional<ClipTurn> turn = take_turn(job, planned.clip.path, account);
        if (!turn) continue;
        std::unique_ptr<Worker> worker = turn->start();
        pool.add(std::move(worker), [&, held = std::make_shared<ClipTurn>(std::move(*turn)),
                                     clip = planned.clip.path](const WorkerEnd& end) {
            const auto lock = environment.signals.hold();
            const bool nothing_drawn = account.outcome().drawn == 0;
            const auto sidecar = finish_turn(*held, clip, end, !(could_not_draw(end) && nothing_drawn), account);
            if (!sidecar) return;
            account.add(*sidecar);
            if (!could_not_draw(end) || !nothing_drawn || ++undrawn < std::min(enough_undrawn, clips.size())) return;
            throw Error(ErrorKind::backend,
                        fmt::format("no clip could be drawn, so this run ends here: {}", sidecar->reason));
        });
    }
    pool.wait_for_all();
    return account.outcome();
}

void write_index(const ArchiveJob& job, const RecorderNames& names, const Environment& environment) {
    const auto held = environment.signals.hold();
    // Of two runs that end together, the later one has to read what the other wrote.
    const std::vector<std::string> files{std::string(index_name)};
    const Claim claim = Claim::wait_for(job.out, files.front());
    if (claim.was_left_behind()) remove_leftovers(job.out, files);
    const Outputs outputs = list_outputs(job.out, job.in);
    tidy(job.out, outputs);
    const DayFiles days = make_day_files(outputs.sidecars, names);
    for (const auto& [name, text] : days) put_file(job.out / name, text);
    put_file(job.out / index_name, make_index(outputs.sidecars, names, gone_of(job.in, outputs.sidecars)));
    remove_other_days(job.out, days);
}

std::size_t prune(const ArchiveJob& job, const Shard& shard, std::size_t clips_there, bool dry_run,
                  const Environment& environment) {
    std::vector<Sidecar> sidecars = list_outputs(job.out, job.in).sidecars;
    std::erase_if(sidecars, [&](const Sidecar& sidecar) {
        return !shard.holds(sidecar.clip.path) || job.days.contains(sidecar.clip.path);
    });
    const Gone gone = find_gone(job.in, sidecars, clips_there);
    for (const std::string& folder : gone.empty_folders) {
        environment.log.warn(
            "'{}' is empty, so its pictures stay: it may be a disk that is not mounted; remove the "
            "folder if its clips are gone for good",
            (job.in / folder).string());
    }
    for (const Sidecar& sidecar : gone.sidecars) {
        const std::string name = text_of_path(sidecar.clip.path);
        if (dry_run) {
            print(fmt::format("{:<15} {}\n", "gone", name));
            continue;
        }
        const auto held = environment.signals.hold();
        remove_outputs(job.out, sidecar);
        environment.log.info("{}: the clip has gone, and its picture with it", name);
    }
    return gone.sidecars.size();
}

}  // namespace vvr
