#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands/command.h"
#include "cli/commands/cut_selection.h"
#include "cli/commands/new_folder.h"
#include "cli/console.h"
#include "cli/excerpt/footage.h"
#include "cli/excerpt/piece.h"
#include "cli/options/command_line.h"
#include "cli/options/job_options.h"
#include "cli/plan/input.h"
#include "cli/plan/observer.h"
#include "cli/plan/settings.h"
#include "cli/signals.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/plane.h"
#include "core/base/setting.h"
#include "core/footage/piece_names.h"
#include "core/image/picture_file.h"
#include "core/media/container.h"
#include "core/media/frame_span.h"

namespace vvr::commands {

namespace {

namespace fs = std::filesystem;

namespace cut_rows {
constexpr Setting output{"output", "FILE",
                         "the piece; the extension names the container; without one, or for a folder, vvr chooses it"};
constexpr Setting event{
    "event",
    "N",
    "cut this event, by its number in the picture, the report and the page; without it, cut from --start to --end",
    {1, 1'000'000'000}};
constexpr Setting evidence{
    "evidence", "DIR",
    "instead of -o: a new folder with the piece, a still in full size, and files that say where they come from, with "
    "SHA-256"};
constexpr Setting report{"report", "FILE",
                         "take the events from this report of `vvr render --report`, without a search"};
constexpr Setting margin{"margin", "TIME", "additional time before and after the piece", {0, 3600}};
}  // namespace cut_rows

void check_not_input(const fs::path& path, const fs::path& input, std::string_view what) {
    std::error_code none;
    if (!fs::equivalent(path, input, none)) return;
    throw Error(ErrorCode::output_replaces_input,
                fmt::format("output '{}' is the same file as the {} '{}'; choose another name for the piece",
                            path.string(), what, input.string()));
}

// ---- The output's name

/// Whether the path is a folder or a name without extension.
bool is_open(const fs::path& path) {
    std::error_code none;
    return !path.has_filename() || fs::is_directory(path, none) || path.extension().empty();
}

/// The extension that fits the piece.
std::string_view extension_of_piece(const CutJob& job, const app::ExcerptFile& first) {
    const std::string_view extension = media::extension_for(media::open_input(first.file.path), job.search.input.rate);
    if (!extension.empty()) return extension;
    throw Error(ErrorCode::input_unsuitable, fmt::format("no container supports all streams of '{}'; {}",
                                                         first.file.path, media::encode_with_ffmpeg));
}

/// The full file name: adds the fitting extension, and in a folder a name based on the first file.
fs::path named(const CutJob& job, const Selection& selection, const app::ExcerptFile& first) {
    if (!is_open(job.path)) return job.path;
    const std::string_view ending = extension_of_piece(job, first);
    std::error_code none;
    const bool is_folder = !job.path.has_filename() || fs::is_directory(job.path, none);
    if (!is_folder) return fs::path(job.path) += ending;
    const std::string stem = fs::path(first.file.path).stem().string();
    const media::FrameSpan& span = selection.span;
    const std::string begin = span.first > 0 ? fmt::format("{}f", span.first) : fmt::format("{:.3f}s", span.start);
    const std::string end = span.stop  ? fmt::format("-{}f", *span.stop)
                            : span.end ? fmt::format("-{:.3f}s", *span.end)
                                       : "";
    const std::string what = job.event ? fmt::format("event-{}", *job.event) : begin + end;
    return job.path / fmt::format("{}-{}{}", stem, what, ending);
}

void check_output(const CutJob& job, const fs::path& path, const app::Footage& footage, app::Observer& observer) {
    for (const footage::Segment& file : footage.recording.segments) check_not_input(path, file.path, "clip");
    if (!job.report.empty()) check_not_input(path, job.report, "report");
    const auto held = observer.guard();
    check_file_path(path);
}

// ---- Properties of the piece

/// Sets the clock of the footage from the first file of the piece.
void set_clock(const CutJob& job, const app::Footage& footage, const media::SegmentPlace& first, app::PieceJob& piece) {
    const auto file = std::ranges::find(footage.recording.segments, first.path, &footage::Segment::path);
    const media::VideoInfo info = info_of(footage, *file, first.begin);
    const app::StartTime& start = job.search.look.start_time;
    piece.clock = app::clock_of(start, info);
    if (start.from != app::StartTime::From::none) piece.created = info.created;
}

/// Reports that no file is shown in the span of the piece.
[[noreturn]] void throw_no_footage(const app::PieceJob& piece) {
    const auto& places = piece.places;
    const auto next = std::ranges::find_if(places, [&](const auto& file) { return file.begin > piece.span.start; });
    double end = 0;
    for (auto file = places.begin(); file != next; ++file) end = std::max(end, file->end);
    const std::string from = app::asked_text(piece, end);
    throw_empty(piece, next == places.end()
                           ? fmt::format("; it ends at {}", from)
                           : fmt::format("; it has none from {} to {}", from, app::asked_text(piece, next->begin)));
}

/// Writes the piece, and logs what the footage lacks in it.
std::optional<app::PieceFacts> write_piece(const app::PieceJob& piece, app::Observer& observer,
                                           const std::stop_token& stop) {
    constexpr std::size_t most = 5;
    const double begin = piece.parts.front().file.begin;
    if (begin > piece.span.start + media::shortest_frame) {
        observer.warn(fmt::format("'{}' has no frames from {} to {}; the piece begins after that", piece.name,
                                  app::asked_text(piece, piece.span.start), app::asked_text(piece, begin)));
    }
    auto facts = app::copy_piece(piece, observer, stop);
    if (!facts) return facts;
    for (const media::FrameGap& gap : std::span(facts->gaps).first(std::min(most, facts->gaps.size()))) {
        observer.warn(fmt::format("'{}' has no frames from {}, where {} missing; the piece keeps this gap", piece.name,
                                  app::interval_text(piece, gap.begin, gap.end),
                                  gap.frames == 1 ? "1 is" : fmt::format("{} are", gap.frames)));
    }
    if (facts->gaps.size() > most)
        observer.warn(fmt::format("'{}' has more gaps in the piece; --evidence lists all", piece.name));
    return facts;
}

// ---- A folder of evidence

/// The events of which a part is in the piece.
std::vector<app::PieceEvent> events_in(const app::PieceFacts& facts, const std::vector<app::PieceEvent>& events) {
    std::vector<app::PieceEvent> found;
    std::ranges::copy_if(events, std::back_inserter(found), [&](const app::PieceEvent& event) {
        return event.last >= facts.begin && event.first <= facts.end;
    });
    return found;
}

/// A copy of a picture with a frame around a box.
Plane<Bgr> with_box(Plane<Bgr> picture, const PixelBox& box) {
    const int thick = std::max(2, std::max(picture.width(), picture.height()) / 400);
    const PixelBox outer = box.inflated(thick, thick);
    for (int y = std::max(0, outer.top); y < std::min(picture.height(), outer.bottom); ++y) {
        for (int x = std::max(0, outer.left); x < std::min(picture.width(), outer.right); ++x) {
            if (!box.contains({x, y, x + 1, y + 1})) picture.at(x, y) = Bgr{0, 0, 255};
        }
    }
    return picture;
}

/// Writes the piece, a still in full size, and where they come from, to a new folder.
/// \param stop request to stop; no file is then left
/// \returns false if it was stopped
bool write_evidence(const CutJob& job, const Selection& selection, app::PieceJob piece, app::Observer& observer,
                    const std::stop_token& stop) {
    const std::string stem = job.event ? fmt::format("event-{}", *job.event) : "piece";
    const std::string file = fmt::format("{}{}", stem, extension_of_piece(job, piece.parts.front()));
    const std::string still = stem + ".png";
    HeldObserver held(observer);  // outlives the folder, so that a signal finds it whole or removed
    NewFolder folder(job.evidence, cut_rows::evidence.name);
    piece.path = folder.hidden() / file;
    piece.place = job.evidence / file;
    const std::optional<app::PieceFacts> facts = write_piece(piece, held, stop);
    if (!facts) return false;
    app::PieceRecord record{piece.camera, piece.clock, selection.settings, selection.unseen, piece.places};
    record.pieces.push_back({file, *facts});
    if (selection.event) record.pieces.front().events = events_in(*facts, selection.known_events);
    for (const app::ExcerptFile& part : piece.parts) {
        record.footage.push_back(app::hashed(part.file.path, part.file.path));
    }
    const double middle = (facts->begin + facts->end) / 2;
    const app::FullFrame frame =
        app::frame_of(piece, selection.event ? selection.event->best.value_or(middle) : middle);
    replace_file(folder.hidden() / still, image::encode_picture(still, frame.picture));
    record.still = app::PieceRecord::Still{still, stem + "-marked.png", frame.seconds, frame.frame};
    if (selection.event) record.still->box = selection.event->best_box;
    if (const auto& box = record.still->box) {
        replace_file(folder.hidden() / record.still->marked,
                     image::encode_picture(still, with_box(frame.picture, *box)));
    }
    app::write_record(folder.hidden(), record, held);
    if (stop.stop_requested()) return false;
    folder.publish();
    if (record.camera.empty()) {
        observer.warn(fmt::format("'{}': the camera is not known; --camera-name names it", piece.name));
    }
    observer.info(fmt::format("'{}': {}, {}{}, {} and {}", job.evidence.string(), file, still,
                              record.still->box ? ", " + record.still->marked : "", footage::record_name,
                              footage::sums_name));
    return true;
}

/// The camera that the user, the report or the names of files tell; empty = unknown.
const std::string& camera_of(const CutJob& job, const Selection& selection, const app::Footage& footage) {
    if (!job.search.input.camera.empty()) return job.search.input.camera;
    return selection.camera.empty() ? footage.recording.camera : selection.camera;
}

/// Writes the piece: copies packets from the preceding key frame on.
/// \param stop request to stop; no file is then left
/// \returns false if it was stopped
/// \throws Error usage, io, not_video, limit
bool cut(const CutJob& asked, app::Observer& observer, const std::stop_token& stop) {
    const bool open = is_open(asked.path);
    if (!open) media::container_of(asked.path);
    const app::Footage footage = app::find_footage(asked.search.input);
    const media::RequestedSpan& asked_span = asked.search.fields.span.asked;
    const CutJob job = in_seconds(asked, footage, observer);
    if (!open) check_output(job, job.path, footage, observer);
    if (!job.evidence.empty()) check_is_free(job.evidence, cut_rows::evidence.name);
    const Selection selection = select_piece(job, footage, observer);
    app::PieceJob piece;
    piece.name = footage.recording.name;
    piece.camera = camera_of(job, selection, footage);
    piece.places = selection.places;
    piece.span = selection.span;
    piece.parts = app::parts_in(selection.places, selection.span);
    piece.input = job.search.input;
    piece.input.rate = footage.recording.rate;
    piece.threads = job.search.fields.threads;
    piece.warns_of_early_end = !job.event;
    set_clock(job, footage, selection.places.front(), piece);
    piece.by_clock = piece.clock && (job.event || asked_span.start || asked_span.end);
    if (piece.parts.empty()) throw_no_footage(piece);
    if (!job.evidence.empty()) return write_evidence(job, selection, std::move(piece), observer, stop);
    piece.path = named(job, selection, piece.parts.front());
    if (open) check_output(job, piece.path, footage, observer);
    return write_piece(piece, observer, stop).has_value();
}

class Cut final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        constexpr options::Group output = options::Group::output;
        const options::AddOptions add(line, output);
        add(cut_rows::output, job_.path,
            {.letter = 'o',
             .help = fmt::format(": {}", fmt::join(names_of(media::containers()), " ")),
             .use = options::FileUse::written});
        add(cut_rows::evidence, job_.evidence, {.use = options::FileUse::written});
        add(cut_rows::event, job_.event);
        add(cut_rows::report, job_.report, {.use = options::FileUse::read});
        add(cut_rows::margin, job_.margin);
        // The options that decide which events exist, and their numbers.
        app::RenderJob& search = job_.search;
        options::add_event_options(line, output, search.output.events);
        options::add_recording_options(line, search.input, options::video_input);
        options::AddOptions(line, options::Group::look)(setting::start_time, search.look.start_time);
        options::add_span_options(line, search.fields.span);
        line.exclude(cut_rows::report, setting::start);
        line.exclude(cut_rows::report, setting::end);
        options::add_field_options(line, search.fields);
        options::add_detector_option(line, search.detector);
        options::add_preset_option(line, options::Group::run);
        options::add_thread_options(line, search.fields.threads);
        line.examples(
            {{"vvr cut clip.avi -o event.mkv --event 1", "the first event of the clip"},
             {"vvr cut clip.avi -o piece.avi --start 0.5s --end 00:00:01.5",
              "a piece, copied from the preceding key frame on"},
             {"vvr cut clip.avi --event 1 --evidence case", "a folder to hand over: piece, still, record, SHA-256"}});
    }

    cli::ExitStatus run(const options::CommandLine& line, const cli::Environment& environment) override {
        app::require_input(job_.search.input);
        if (job_.path.empty() && job_.evidence.empty())
            throw Error(ErrorCode::output_missing, "no output given; name the file for the piece with -o FILE");
        if (!job_.path.empty() && !job_.evidence.empty()) {
            throw Error(ErrorCode::options_conflict,
                        "--evidence writes the piece into its own folder; drop -o, or drop --evidence",
                        {cut_rows::evidence.name});
        }
        if (!job_.event && !line.has(setting::start) && !line.has(setting::end)) {
            throw Error(ErrorCode::usage,
                        "no piece chosen; choose one with --event N, or with --start TIME and --end TIME");
        }
        refuse_search_options(line);
        job_.search.settings = options::record_of_fields(line);
        cli::Console console(environment);
        cli::run_stoppable(environment.signals, [&](const std::stop_token& stop) { return cut(job_, console, stop); });
        return cli::ExitStatus::done;
    }

  private:
    /// Refuses options of a search for events, if there is none.
    void refuse_search_options(const options::CommandLine& line) const {
        if (job_.event && job_.report.empty()) return;
        std::vector<std::string> names{std::string(setting::events.name), std::string(setting::between.name)};
        for (const options::OptionValue& value : line.values(std::array{options::Group::fields}))
            names.push_back(value.name);
        const auto name = std::ranges::find_if(names, [&](const std::string& of) { return line.is_argument(of); });
        if (name == names.end()) return;
        if (!job_.event) {
            throw Error(ErrorCode::option_needs_another,
                        fmt::format("--{} is for the search for events; add --event N", *name));
        }
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("--{} is for the search for events, but --report has them already; drop one of them", *name));
    }

    CutJob job_;
};

}  // namespace

std::unique_ptr<Command> make_cut() {
    return std::make_unique<Cut>();
}

}  // namespace vvr::commands
