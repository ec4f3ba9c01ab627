#include "cli/workers/archive_clip.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <new>
#include <set>
#include <span>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "cli/exit_status.h"
#include "cli/workers/worker_end.h"
#include "core/archive/event_lines.h"
#include "core/archive/output_files.h"
#include "core/archive/pieces.h"
#include "core/archive/prune.h"
#include "core/base/atomic_file.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/version.h"
#include "core/media/settings.h"
#include "core/page/html.h"

namespace vvr::workers {

namespace {

namespace fs = std::filesystem;

/// Why none of the files can be opened, as in errno; 0 = one can. ENOENT = all are gone.
int error_of_opening(const fs::path& in, const std::vector<std::string>& files) {
    int error = ENOENT;
    for (const std::string& file : files) {
        const Descriptor opened(::open((in / file).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
        if (opened.get() >= 0) return 0;
        if (errno != ENOENT) error = errno;
    }
    return error;
}

void remove_files(const fs::path& out, const std::string& clip, const std::vector<archive::OutputKind>& kinds,
                  const std::vector<archive::OutputKind>& kept) {
    for (const archive::OutputKind kind : kinds) {
        std::error_code none;
        if (std::ranges::count(kept, kind) == 0) archive::remove_own(archive::output_path(out, clip, kind), none);
    }
}

}  // namespace

std::unique_ptr<Worker> start_drawing_test(const ArchiveJob& job) {
    WorkerLimits limits = job.limits;
    limits.time = std::chrono::minutes(1);
    return std::make_unique<Worker>(WorkerPlan{"doctor", {}, job.drawn_with}, job.threads, limits, -1,
                                    job.sandbox->around({}, job.out));
}

bool affects_one_file(const Error& error) {
    return error.kind() == ErrorKind::io && error.code() != ErrorCode::disk_full;
}

ClipTask::ClipTask(const ArchiveJob& job, archive::Clip clip, std::optional<archive::Sidecar> before, LockFile claim)
    : job_(&job), clip_(std::move(clip)), before_(std::move(before)), lock_(std::move(claim)) {}

ClipTask::~ClipTask() {
    if (finished_ || lock_.descriptor() < 0) return;
    remove_leftovers(folder(), archive::written_names(file_name()));
    archive::remove_staging(staging());
    // Its events were not reported, and the next run must not take it for a report whose events were.
    if (report_moved_ && !before_) remove_files(job_->out, clip_.path, {archive::OutputKind::report}, {});
}

fs::path ClipTask::folder() const {
    return archive::sidecar_path(job_->out, clip_.path).parent_path();
}

fs::path ClipTask::staging() const {
    return archive::staging_of(job_->out, clip_.path);
}

fs::path ClipTask::staged(archive::OutputKind kind) const {
    return archive::output_path(staging(), file_name(), kind);
}

fs::path ClipTask::staged_pieces() const {
    return staging() / "events";
}

std::string ClipTask::file_name() const {
    return fs::path(clip_.path).filename().string();
}

const archive::CameraDay* ArchiveJob::day_of(const std::string& path) const {
    const auto found = days.find(path);
    return found == days.end() ? nullptr : &found->second;
}

std::string ArchiveJob::camera_of(const std::string& path) const {
    const archive::CameraDay* const day = day_of(path);
    return day != nullptr ? day->camera : names.camera_of(path);
}

const PictureSettings& ArchiveJob::pictures_of(const std::string& path) const {
    if (of_cameras.empty()) return pictures;
    std::vector<std::string> cameras;
    for (const auto& [camera, settings] : of_cameras) cameras.push_back(camera);
    const auto own = of_cameras.find(footage::name_of_camera(camera_of(path), cameras));
    return own == of_cameras.end() ? pictures : own->second;
}

archive::Need ArchiveJob::need_of(const archive::Clip& clip, const std::optional<archive::Sidecar>& sidecar) const {
    archive::ArchiveRules all = rules;
    all.settings = pictures_of(clip.path).digest;
    const auto need_by = day_of(clip.path) != nullptr ? archive::need_of_day : archive::need_of;
    const archive::Need need = need_by(clip, sidecar, out, all, std::chrono::system_clock::now());
    if (need != archive::Need::nothing || !sidecar->day || sidecar->day->unread.empty()) return need;
    const int error = error_of_opening(in, sidecar->day->unread);
    return error == 0 ? archive::Need::retry : error == ENOENT ? need : archive::Need::unread;
}

const archive::CameraDay* ClipTask::day() const {
    return job_->day_of(clip_.path);
}

/// The camera as the index shows it; empty for clips at the top of the archive.
std::string ClipTask::camera() const {
    return archive::text_of_path(job_->camera_of(clip_.path));
}

namespace {

/// Removes pieces that a killed run moved to their place, but that the sidecar doesn't list.
void remove_unlisted_pieces(const fs::path& folder, const archive::Sidecar& sidecar) {
    std::vector<std::string> names = archive::list_pieces(folder);
    std::erase_if(names, [&](const auto& name) { return std::ranges::count(sidecar.pieces, name) > 0; });
    archive::remove_pieces(folder, names);
}

[[noreturn]] void throw_no_folder(const fs::path& folder, const std::error_code& error) {
    throw system_error(error.value(), fmt::format("cannot create the folder '{}'", folder.string()),
                       "choose another -o, or remove what is in its place");
}

}  // namespace

std::optional<ClipTask> ClipTask::take(const ArchiveJob& job, const std::string& path) {
    const fs::path folder = archive::sidecar_path(job.out, path).parent_path();
    const std::string name = fs::path(path).filename().string();
    archive::check_own_folder(job.out, folder);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw_no_folder(folder, error);
    }
    std::optional<LockFile> claim = LockFile::try_take(folder, name);
    if (!claim) return std::nullopt;
    if (claim->is_stale()) archive::remove_unfinished(job.out, job.in, path, *claim);
    archive::remove_staging(archive::staging_of(job.out, path));
    // The clip may have changed since the scan, or another run may have done it.
    const auto day = job.days.find(path);
    const bool is_day = day != job.days.end();
    std::optional<archive::Clip> clip = is_day ? day->second.clip : archive::stat_clip(job.in, path);
    if (!clip) return std::nullopt;
    std::optional<archive::Sidecar> before = archive::read_sidecar(job.out, path);
    if (!archive::wants_work(job.need_of(*clip, before))) return std::nullopt;
    // Without permission to read it, the clip is not at fault: this is no try, and no sidecar says that it has failed.
    const int error_of_clip = error_of_opening(job.in, is_day ? day->second.files : std::vector{path});
    if (error_of_clip == ENOENT) return std::nullopt;
    if (error_of_clip != 0) {
        throw system_error(error_of_clip, fmt::format("cannot read '{}'", (job.in / path).string()),
                           "check its permissions and those of its folder");
    }
    archive::check_own_place(archive::sidecar_path(job.out, path));
    const fs::path pieces = archive::pieces_folder(job.out, path);
    if (job.pieces_margin) archive::check_own_folder(folder, pieces);
    if (claim->is_stale() && before) remove_unlisted_pieces(pieces, *before);
    for (const archive::OutputKind kind : job.rules.files)
        archive::check_own_place(archive::output_path(job.out, path, kind));
    ClipTask task(job, std::move(*clip), std::move(before), std::move(*claim));
    std::vector<fs::path> folders{task.staging()};
    if (job.pieces_margin) folders.push_back(task.staged_pieces());  // a worker may make no folder
    for (const fs::path& place : folders) {
        fs::create_directory(place, error);
        if (error) throw_no_folder(place, error);
    }
    return task;
}

std::string_view lacks_time(const archive::DayRule& rule) {
    return rule.by_container ? "no time in the names or containers of" : "no recording time in the names of";
}

/// "gate", "gate, night of 2026-11-21". The clock of a picture has the date of a day. Files without times in their
/// names don't tell which night they show.
static std::string title_of(const archive::CameraDay& day) {
    std::string camera = archive::text_of_path(day.camera);
    if (!day.rule.is_night() || day.undated.size() == day.files.size()) return camera;
    return fmt::format("{}{}{}", camera, camera.empty() ? "" : ", ", archive::words_of_day(day.date, day.rule));
}

/// A warning about files that may be on a wrong day; empty if there are none.
static std::string undated_files_of(const archive::CameraDay& day) {
    if (day.undated.empty()) return {};
    return fmt::format(
        "'{}': {} {} of {}; the date is that of their last modification, which may be wrong; describe the names with "
        "--names",
        archive::text_of_path(day.clip.path), lacks_time(day.rule), day.undated.size(),
        counted(static_cast<std::int64_t>(day.files.size()), "file"));
}

std::unique_ptr<Worker> ClipTask::start() const {
    static constexpr std::array outputs{
        std::pair{archive::OutputKind::picture, "output"},      std::pair{archive::OutputKind::page, "page"},
        std::pair{archive::OutputKind::thumbnail, "thumbnail"}, std::pair{archive::OutputKind::report, "report"},
        std::pair{archive::OutputKind::still, "still"},         std::pair{archive::OutputKind::stills, "stills"}};
    WorkerPlan plan{"render", {}, {{"quiet", "true"}, {"plain-name", "true"}, {"detector-tried", "true"}}};
    const auto set = [&plan](const char* name, std::string value) {
        if (!value.empty()) plan.settings.emplace_back(name, std::move(value));
    };
    set("threads", fmt::format("{}", job_->threads));
    std::vector<fs::path> read;
    for (const std::string& file : day() != nullptr ? day()->files : std::vector{clip_.path})
        plan.inputs.push_back(read.emplace_back(job_->in / file).string());
    if (day() != nullptr) {
        set("join", "true");  // the scan has already grouped the files by camera
        set("title", title_of(*day()));
        set("input-problem", undated_files_of(*day()));
    }
    for (const auto& [kind, name] : outputs) {
        if (std::ranges::count(job_->rules.files, kind) > 0) set(name, staged(kind).string());
    }
    if (std::ranges::count(job_->rules.files, archive::OutputKind::page) > 0) {
        set("page-index", (job_->out / archive::index_name).string());
        set("page-place", archive::output_path(job_->out, clip_.path, archive::OutputKind::page).string());
        if (day() != nullptr) set("page-heading", title_of(*day()));
    }
    WorkerLimits limits = job_->limits;
    if (job_->pieces_margin) {
        set("pieces", staged_pieces().string());
        set("pieces-place", archive::pieces_folder(job_->out, clip_.path).string());
        set("pieces-margin", fmt::format("{}", *job_->pieces_margin));
        read.push_back(staged_pieces());  // a copy is compared with the clip before it counts
        // Pieces don't overlap, but each begins at a key frame before it.
        limits.written += 2 * clip_.size;
        limits.file = std::max(limits.file, limits.written);
    }
    set("page-camera", camera());
    const Settings& own = job_->pictures_of(clip_.path).settings;
    plan.settings.insert(plan.settings.end(), own.begin(), own.end());
    return std::make_unique<Worker>(plan, job_->threads, limits, lock_.descriptor(),
                                    job_->sandbox->around(read, folder()));
}

/// The sidecar of a clip that was drawn.
archive::Sidecar ClipTask::read_results(const WorkerResult& end) const {
    archive::Sidecar sidecar;
    sidecar.clip = clip_;
    if (day() != nullptr) {
        sidecar.day =
            archive::Sidecar::Day{day()->camera, day()->date, std::ssize(day()->files), day()->files, day()->rule};
    }
    sidecar.settings = job_->pictures_of(clip_.path).digest;
    sidecar.version = version();
    sidecar.took = rounded(end.seconds);
    sidecar.files = job_->rules.files;
    sidecar.status = end.status;
    if (is_not_whole(end)) {
        sidecar.code = code_of(end);
        sidecar.reason = error_text_of(end);
    }
    archive::apply_report(sidecar, staged(archive::OutputKind::report));
    if (day() != nullptr) {
        const std::set<std::string> read = archive::read_older_report(staged(archive::OutputKind::report)).files;
        for (const std::string& file : day()->files) {
            if (read.contains((job_->in / file).string())) continue;
            const int error = error_of_opening(job_->in, {file});
            if (error == ENOENT) continue;  // the recorder has removed it
            sidecar.code = ErrorCode::partial;
            if (error != 0) sidecar.day->unread.push_back(file);
        }
    }
    // A run whose clip has lost events is no success, although the picture is drawn.
    if (sidecar.code) sidecar.status = static_cast<int>(cli::ExitStatus::partial);
    if (archive::lacks_pieces(sidecar)) sidecar.tries = earlier_tries() + 1;
    sidecar.pieces = archive::list_pieces(staged_pieces());
    for (const archive::OutputKind kind : sidecar.files) {
        if (archive::is_own_file(staged(kind))) continue;
        throw Error(ErrorCode::worker_result_invalid, fmt::format("the worker reported success but did not write '{}'",
                                                                  archive::output_path("", clip_.path, kind).string()));
    }
    return sidecar;
}

/// Call it while the older report is still in its place. Whoever removes a sidecar to have a clip drawn again leaves
/// it, so it counts without one too. That of a killed run has been removed: its events were not reported.
std::vector<tracking::EventLine> ClipTask::find_new_events(const archive::Sidecar& sidecar) const {
    if (!job_->reports_events || !sidecar.events) return {};
    const archive::OlderReport older =
        archive::read_older_report(archive::output_path(job_->out, clip_.path, archive::OutputKind::report));
    std::vector<tracking::EventLine> lines =
        archive::new_events(staged(archive::OutputKind::report), older,
                            day() != nullptr ? archive::Reported::day : archive::Reported::clip);
    const bool has_page = std::ranges::count(sidecar.files, archive::OutputKind::page) > 0;
    const fs::path page = archive::output_path("", clip_.path, archive::OutputKind::page);
    for (tracking::EventLine& line : lines) {
        line.camera = camera();
        const fs::path file = fs::path(line.clip).lexically_relative(job_->in);
        line.clip = archive::text_of_path(file.string());
        if (!has_page) continue;
        line.page = page::url_of_path(page.string());
        if (line.number > 0) line.page += fmt::format("#event={}", line.number);
    }
    return lines;
}

/// How often this version has failed to draw the clip as it is now with these limits, or to keep its events.
int ClipTask::earlier_tries() const {
    const bool again = before_ &&
                       (before_->state == archive::Sidecar::State::failed || archive::lacks_pieces(*before_)) &&
                       before_->version == version() && before_->settings == job_->pictures_of(clip_.path).digest &&
                       before_->clip.size == clip_.size && before_->clip.modified == clip_.modified &&
                       !archive::is_limit_raised(*before_, job_->rules.limits);
    return again ? before_->tries : 0;
}

/// Adds the pieces of an earlier run that are still there.
void ClipTask::add_older_pieces(archive::Sidecar& sidecar) const {
    const fs::path folder = archive::pieces_folder(job_->out, clip_.path);
    for (const std::string& name : before_->pieces) {
        if (std::ranges::count(sidecar.pieces, name) == 0 && archive::has_pieces(folder, std::span(&name, 1)))
            sidecar.pieces.push_back(name);
    }
}

/// The sidecar of a clip that failed. It keeps what is known about files of an earlier run.
archive::Sidecar ClipTask::failure(int status, ErrorCode code, const std::string& reason, double seconds) const {
    archive::Sidecar sidecar;
    if (before_ && !before_->files.empty()) {
        sidecar = *before_;
        std::erase_if(sidecar.files, [&](archive::OutputKind kind) {
            return !archive::is_own_file(archive::output_path(job_->out, clip_.path, kind));
        });
        sidecar.pieces.clear();  // `finish` adds those that are there
        if (!sidecar.files.empty()) {
            sidecar.shows = archive::shown_by(*before_);
        } else {
            sidecar = archive::Sidecar();
        }
    }
    sidecar.clip = clip_;
    if (day() != nullptr) {
        // The day is gone only when all clips are gone that its picture shows or should show.
        std::set<std::string> files(day()->files.begin(), day()->files.end());
        if (sidecar.shows && sidecar.day) files.insert(sidecar.day->files.begin(), sidecar.day->files.end());
        sidecar.day = archive::Sidecar::Day{
            day()->camera, day()->date, std::ssize(day()->files), {files.begin(), files.end()}, day()->rule};
    }
    sidecar.settings = job_->pictures_of(clip_.path).digest;
    sidecar.version = version();
    sidecar.took = rounded(seconds);
    sidecar.state = archive::Sidecar::State::failed;
    sidecar.tries = earlier_tries() + 1;
    sidecar.limits.reset();
    if (row_of(code).kind == ErrorKind::limit) {
        sidecar.limits = job_->rules.limits;
        // A share of the memory that goes up and down must not start the tries again and again.
        if (earlier_tries() > 0 && before_->limits) {
            sidecar.limits->seconds = std::max(sidecar.limits->seconds, before_->limits->seconds);
            sidecar.limits->memory = std::max(sidecar.limits->memory, before_->limits->memory);
        }
    }
    sidecar.status = status;
    sidecar.code = code;
    sidecar.reason = reason;
    return sidecar;
}

/// Whether the clip has no frame in the span that is to be drawn. Believed only if there is such a span.
bool ClipTask::is_outside(const WorkerResult& end) const {
    static constexpr std::array spans{setting::start.name, setting::end.name, setting::between.name};
    return failed(end) && code_of(end) == ErrorCode::span_empty &&
           std::ranges::any_of(job_->pictures_of(clip_.path).settings, [](const auto& setting) {
               return std::ranges::find(spans, setting.first) != spans.end();
           });
}

archive::Sidecar ClipTask::finish(const WorkerResult& end, cli::Signals& signals) {
    throw_if_system_fault(clip_.path, folder(), end);
    archive::Sidecar sidecar;
    try {
        sidecar = failed(end) ? failure(status_of(end), code_of(end), reason_of(end, job_->limits), end.seconds)
                              : read_results(end);
        if (is_outside(end)) {
            sidecar.state = archive::Sidecar::State::outside;
            sidecar.files.clear();
            sidecar.shows.reset();
        }
        // The pieces of an earlier run may be all that is left of its footage: no picture with fewer replaces them.
        if (archive::lacks_pieces(sidecar) && before_ && !before_->pieces.empty())
            sidecar = failure(status_of(end), *sidecar.code, sidecar.reason, end.seconds);
        if (sidecar.state == archive::Sidecar::State::done) new_events_ = find_new_events(sidecar);
    } catch (const Error& error) {
        sidecar = failure(status_of(end), ErrorCode::worker_result_invalid, error.what(), end.seconds);
    } catch (const std::bad_alloc&) {
        sidecar = failure(status_of(end), ErrorCode::worker_result_invalid, "its report is too large to fit in memory",
                          end.seconds);
    }
    const auto held = signals.hold();
    const fs::path pieces = archive::pieces_folder(job_->out, clip_.path);
    if (sidecar.state == archive::Sidecar::State::done) {
        archive::move_pieces(staged_pieces(), pieces, sidecar.pieces);
        for (const archive::OutputKind kind : sidecar.files) {
            const fs::path place = archive::output_path(job_->out, clip_.path, kind);
            std::error_code error;
            fs::rename(staged(kind), place, error);
            if (error)
                throw system_error(error.value(), fmt::format("cannot write '{}'", place.string()),
                                   "choose another folder or fix its permissions");
            if (kind == archive::OutputKind::report) report_moved_ = true;
        }
    }
    // Pieces whose footage can't be copied any more have no replacement.
    if (before_ && (sidecar.state == archive::Sidecar::State::failed || (job_->pieces_margin && sidecar.code)))
        add_older_pieces(sidecar);
    archive::write_sidecar(job_->out, sidecar);
    if (before_) {
        remove_files(job_->out, clip_.path, before_->files, sidecar.files);
        std::vector<std::string> others = before_->pieces;
        std::erase_if(others, [&](const auto& name) { return std::ranges::count(sidecar.pieces, name) > 0; });
        archive::remove_pieces(pieces, others);
    }
    archive::remove_staging(staging());
    finished_ = true;
    return sidecar;
}

}  // namespace vvr::workers
