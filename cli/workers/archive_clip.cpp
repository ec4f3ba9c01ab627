#include "cli/workers/archive_clip.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "cli/exit_status.h"
#include "core/archive/prune.h"
#include "core/image/atomic_file.h"
#include "core/version.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_reason = 600;
constexpr int killed = 128;  // and the signal's number, as a shell shows it
constexpr int not_started = 127;

/// What vvr said last, an error of several lines as one; where it said nothing, what was said at all.
std::string last_words(const std::string& said) {
    constexpr std::string_view own = "vvr: ";
    std::size_t begin = said.starts_with(own) ? 0 : std::string::npos;
    if (const auto later = said.rfind("\nvvr: "); later != std::string::npos) begin = later + 1;
    std::string words = begin == std::string::npos ? said : said.substr(begin + own.size());
    std::ranges::replace_if(
        words, [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    words.erase(words.find_last_not_of(' ') + 1);
    return words.substr(0, longest_reason);
}

std::string reason_of(const WorkerEnd& end, const WorkerLimits& limits) {
    const std::string words = last_words(end.said);
    if (end.timed_out) {
        return fmt::format("it took longer than the {} s that --timeout allows", limits.time.count());
    }
    if (end.status > killed) {
        const int signal = end.status - killed;
        return fmt::format(
            "the worker was ended by signal {} ({}), for a bug or for more memory than --max-memory "
            "allows, {} MB{}{}",
            signal, ::strsignal(signal), limits.memory / 1'000'000, words.empty() ? "" : ": ", words);
    }
    if (end.status == static_cast<int>(ExitStatus::limit)) {
        return fmt::format("{}; --max-memory gives a worker {} MB", words, limits.memory / 1'000'000);
    }
    return words.empty() ? fmt::format("the worker ended with status {} and said nothing", end.status) : words;
}

void throw_if_not_the_clips_fault(const std::string& clip, const WorkerEnd& end) {
    if (end.timed_out) return;
    const std::string words = last_words(end.said);
    if (end.status == static_cast<int>(ExitStatus::io) && is_disk_full(words)) throw Error(ErrorKind::io, words);
    if (end.status != not_started) return;
    throw Error(ErrorKind::limit,
                words.empty()
                    ? fmt::format("the worker for '{}' could not be started; is vvr's own file still there?", clip)
                    : words);
}

void remove_files(const fs::path& out, const std::string& clip, const std::vector<OutputKind>& kinds,
                  const std::vector<OutputKind>& kept) {
    for (const OutputKind kind : kinds) {
        std::error_code none;
        if (std::ranges::count(kept, kind) == 0) fs::remove(output_path(out, clip, kind), none);
    }
}

}  // namespace

bool could_not_draw(const WorkerEnd& end) {
    return end.status == static_cast<int>(ExitStatus::backend);
}

bool is_disk_full(const std::string& text) {
    // A name in quotes may say anything; the reason comes after it.
    const auto quote = text.rfind('\'');
    const std::string reason = quote == std::string::npos ? text : text.substr(quote);
    return std::ranges::any_of(std::array{ENOSPC, EDQUOT, EFBIG}, [&](int error) {
        return reason.find(std::generic_category().message(error)) != std::string::npos;
    });
}

ClipTurn::ClipTurn(const ArchiveJob& job, Clip clip, std::optional<Sidecar> before, Claim claim)
    : job_(&job), clip_(std::move(clip)), before_(std::move(before)), claim_(std::move(claim)) {}

ClipTurn::~ClipTurn() {
    if (!finished_ && claim_.descriptor() >= 0) remove_leftovers(folder(), written_names(file_name()));
}

fs::path ClipTurn::folder() const {
    return sidecar_path(job_->out, clip_.path).parent_path();
}

std::string ClipTurn::file_name() const {
    return fs::path(clip_.path).filename().string();
}

const CameraDay* ClipTurn::day() const {
    const auto found = job_->days.find(clip_.path);
    return found == job_->days.end() ? nullptr : &found->second;
}

std::optional<ClipTurn> ClipTurn::take(const ArchiveJob& job, const std::string& path) {
    const fs::path folder = sidecar_path(job.out, path).parent_path();
    const std::string name = fs::path(path).filename().string();
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw Error(ErrorKind::io, fmt::format("cannot make the folder '{}': {}; choose another -o, or fix what is in "
                                               "the way",
                                               folder.string(), error.message()));
    }
    std::optional<Claim> claim = Claim::try_take(folder, name);
    if (!claim) return std::nullopt;
    if (claim->was_left_behind()) remove_leftovers(folder, written_names(name));
    // It may have changed, or been done, since it was found.
    const auto day = job.days.find(path);
    const bool is_day = day != job.days.end();
    std::optional<Clip> clip = is_day ? day->second.clip : look_at_clip(job.in, path);
    if (!clip) return std::nullopt;
    std::optional<Sidecar> before = read_sidecar(job.out, path);
    const auto now = std::chrono::system_clock::now();
    const Need need = (is_day ? need_of_day : need_of)(*clip, before, job.out, job.rules, now);
    if (!wants_work(need)) return std::nullopt;
    return ClipTurn(job, std::move(*clip), std::move(before), std::move(*claim));
}

std::unique_ptr<Worker> ClipTurn::start() const {
    static constexpr std::array options{
        std::pair{OutputKind::picture, "--output="}, std::pair{OutputKind::page, "--page="},
        std::pair{OutputKind::thumbnail, "--thumbnail="}, std::pair{OutputKind::report, "--report="},
        std::pair{OutputKind::still, "--still="}};
    std::vector<std::string> arguments{"render", "--no-config", "--quiet", "--plain-name",
                                       fmt::format("--threads={}", job_->threads)};
    std::vector<fs::path> read;
    for (const std::string& file : day() != nullptr ? day()->files : std::vector{clip_.path}) {
        const std::string clip = read.emplace_back(job_->in / file).string();
        // So that no name is taken for an option or a list.
        const bool plain = clip.front() != '-' && clip.front() != '[';
        arguments.push_back(plain ? clip : "./" + clip);
    }
    if (day() != nullptr && !day()->camera.empty()) arguments.push_back("--title=" + text_of_path(day()->camera));
    for (const auto& [kind, option] : options) {
        if (std::ranges::count(job_->rules.files, kind) == 0) continue;
        arguments.push_back(option + output_path(job_->out, clip_.path, kind).string());
    }
    if (std::ranges::count(job_->rules.files, OutputKind::page) > 0) {
        arguments.push_back("--page-index=" + (job_->out / index_name).string());
    }
    arguments.insert(arguments.end(), job_->options.begin(), job_->options.end());
    return std::make_unique<Worker>(arguments, job_->threads, job_->limits, claim_.descriptor(),
                                    job_->sandbox->around(read, folder()));
}

Sidecar ClipTurn::finish(const WorkerEnd& end, bool counts) {
    throw_if_not_the_clips_fault(clip_.path, end);
    if (end.status >= killed) remove_leftovers(folder(), written_names(file_name()));
    Sidecar sidecar;
    sidecar.clip = clip_;
    if (day() != nullptr) sidecar.day = Sidecar::Day{day()->camera, day()->date, std::ssize(day()->files)};
    sidecar.settings = job_->rules.settings;
    sidecar.version = version();
    sidecar.took = std::round(end.seconds * 1000) / 1000;
    if (end.status == 0 && !end.timed_out) {
        sidecar.files = job_->rules.files;
        take_report(sidecar, output_path(job_->out, clip_.path, OutputKind::report));
    } else {
        const bool again = before_ && before_->state == Sidecar::State::failed && before_->version == sidecar.version &&
                           before_->settings == sidecar.settings && before_->clip.size == clip_.size &&
                           before_->clip.modified == clip_.modified;
        sidecar.state = Sidecar::State::failed;
        sidecar.tries = (again ? before_->tries : 0) + (counts ? 1 : 0);
        sidecar.status = end.timed_out ? static_cast<int>(ExitStatus::limit) : end.status;
        sidecar.reason = reason_of(end, job_->limits);
        remove_files(job_->out, clip_.path, job_->rules.files, {});
    }
    write_sidecar(job_->out, sidecar);
    if (before_) remove_files(job_->out, clip_.path, before_->files, sidecar.files);
    finished_ = true;
    return sidecar;
}

}  // namespace vvr
