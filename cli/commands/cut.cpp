#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/app/input.h"
#include "cli/app/job.h"
#include "cli/app/observe.h"
#include "cli/app/observer.h"
#include "cli/app/settings.h"
#include "cli/commands/command.h"
#include "cli/commands/footage.h"
#include "cli/commands/write_piece.h"
#include "cli/console.h"
#include "cli/options/job_options.h"
#include "cli/options/output.h"
#include "cli/options/parse_value.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/image/atomic_file.h"
#include "core/video/container.h"
#include "core/video/frame_span.h"
#include "core/video/packet_range.h"

namespace vvr::commands {

namespace {

/// A piece of a clip or a recording, and its output. The piece is an event or lies between two times.
struct CutJob {
    app::RenderJob search;              ///< the footage, its clock, and how to find events in it; nothing is drawn
    std::filesystem::path report;       ///< a report with the events; empty = search for events
    std::optional<std::int64_t> event;  ///< number of the event, from 1
    std::optional<app::Time> from;      ///< none = the beginning
    std::optional<app::Time> to;        ///< the first frame after the piece; none = to the end
    video::RequestedSpan asked{};       ///< wall-clock times, in place of `from` and `to`
    double margin = 0;                  ///< seconds before and after
    bool exact = false;                 ///< encode exactly the frames of the piece, without sound
    std::filesystem::path path;         ///< a file, a name without extension, or a folder; missing parts are chosen
};

namespace fs = std::filesystem;

constexpr double little = 0.002;  // seconds; shorter than any frame, longer than the rounding of times

void check_not_input(const fs::path& path, const fs::path& input, std::string_view what) {
    std::error_code none;
    if (!fs::equivalent(path, input, none)) return;
    throw Error(ErrorCode::output_replaces_input,
                fmt::format("output '{}' is the same file as the {} '{}'; choose another name for the piece",
                            path.string(), what, input.string()));
}

/// Rounds a time to milliseconds.
double rounded(double seconds) {
    return std::round(seconds * 1000) / 1000;
}

/// The part of the footage that is in the piece.
struct Selection {
    video::FrameSpan span;
    std::vector<video::SegmentPlace> places;
};

// ---- An event

const EventTimes& choose_event(const CutJob& job, const std::vector<EventTimes>& events, const std::string& where) {
    const auto count = std::ssize(events);
    if (*job.event >= 1 && *job.event <= count) return events[static_cast<std::size_t>(*job.event - 1)];
    const std::string what = count == 0   ? "has no events"
                             : count == 1 ? "has 1 event; choose 1"
                                          : fmt::format("has {} events; choose 1 to {}", count, count);
    throw Error(ErrorCode::event_unknown, fmt::format("event {}: '{}' {}", *job.event, where, what), {"event"});
}

video::FrameSpan span_of(const EventTimes& event, double margin) {
    // A span's end is exclusive, but the event's last frame is part of it.
    video::FrameSpan span;
    span.start = rounded(std::max(0.0, event.first - margin));
    span.end = rounded(event.last + margin) + little;
    return span;
}

Selection find_event(const CutJob& job, const Footage& footage, app::Observer& observer) {
    app::validate(job.search);
    const fields::FilterRow& filter = *job.search.fields.filter;
    if (!filter.traits.shows_object) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("filter '{}' does not mark objects, so there are no events; choose another filter",
                                filter.name),
                    {"filter"});
    }
    const app::OpenedFields fields = app::open_fields(job.search);
    app::RenderJob search = job.search;
    search.look.show = {};
    const app::Plan plan = app::make_plan(std::move(search), fields.facts(), app::Purpose::search);
    std::vector<EventTimes> events;
    const app::Observation seen = app::observe(plan, *fields.source, observer);
    for (const events::Event& event : seen.events->events) {
        events.push_back({event.first.seconds, event.last.seconds});
    }
    const video::FrameSpan span = span_of(choose_event(job, events, footage.recording.name), job.margin);
    if (footage.is_single) return {span, place_by_packets(footage, job.search.input.rate, span.end, observer)};
    return {span, fields.source->info().segments};
}

Selection read_event(const CutJob& job, const Footage& footage) {
    const ReportedEvents reported = read_events(job.report);
    const EventTimes& event = choose_event(job, reported.times, job.report.string());
    const auto number = static_cast<std::size_t>(*job.event - 1);
    return {span_of(event, job.margin), place_by_report(footage, reported, number, job.margin, job.report.string())};
}

// ---- Between two times

/// Properties of the recording that say when its second 0 was.
/// \param file of the footage
/// \param begin of the file, in seconds of the recording
video::VideoInfo info_of(const Footage& footage, const video::Segment& file, double begin, double rate) {
    const video::ClipHeader header =
        video::header_of(video::Demuxer(video::open_input(file.path), video::Demuxer::Kind::video, rate));
    const std::int64_t before = std::llround(begin);
    video::VideoInfo info;
    info.name = footage.recording.name;
    info.duration = begin + header.length;
    if (file.begin) info.began = *file.begin - before;
    info.began_source = file.begin_source;
    if (header.created) info.created = *header.created - before;
    return info;
}

/// The job with wall-clock times converted to seconds of the recording.
CutJob in_seconds(CutJob job, const Footage& footage, app::Observer& observer) {
    if (!job.asked.start && !job.asked.end) return job;
    const video::VideoInfo info = info_of(footage, footage.recording.segments.front(), 0, job.search.input.rate);
    const WallClock known = app::clock_of(job.search.look.start_time, info);
    const auto seconds = [&](const video::RequestedTime& asked, std::string_view setting, double from) {
        return app::Time{video::seconds_of(asked, video::require_clock(known, info, setting, asked.text), from),
                         app::Time::Unit::seconds};
    };
    if (job.asked.start) {
        job.from = seconds(*job.asked.start, "from", 0);
        if (job.from->value < 0) {
            observer.warn(fmt::format("'{}' begins at {}, later than the requested start of the piece", info.name,
                                      known->iso(0)));
            job.from->value = 0;
        }
    }
    const double begin = job.from && job.from->unit == app::Time::Unit::seconds ? job.from->value : 0;
    if (job.asked.end) job.to = seconds(*job.asked.end, "to", begin + 1e-3);
    return job;
}

void check_unit(const CutJob& job, const Footage& footage, const app::Time& time, std::string_view option) {
    if (time.unit == app::Time::Unit::seconds || time.value == 0) return;
    if (job.margin > 0) {
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("margin needs times in seconds, but {} {:.0f}f is a frame number; give a time such as 12.5s",
                        option, time.value),
            {"margin"});
    }
    if (footage.is_single) return;
    throw Error(ErrorCode::option_value,
                fmt::format("{} {:.0f}f is a frame number, which is unknown in a recording of several files until it "
                            "is decoded; give a time such as 12.5s",
                            option, time.value),
                {option});
}

video::FrameSpan span_between(const CutJob& job, const Footage& footage) {
    video::FrameSpan span;
    if (job.from) {
        check_unit(job, footage, *job.from, "from");
        if (job.from->unit == app::Time::Unit::seconds) span.start = std::max(0.0, job.from->value - job.margin);
        if (job.from->unit == app::Time::Unit::frames) span.first = static_cast<std::int64_t>(job.from->value);
    }
    if (job.to) {
        check_unit(job, footage, *job.to, "to");
        if (job.to->unit == app::Time::Unit::seconds) span.end = job.to->value + job.margin;
        if (job.to->unit == app::Time::Unit::frames) span.stop = static_cast<std::int64_t>(job.to->value);
    }
    const bool same_unit = job.to && (!job.from || job.from->unit == job.to->unit);
    if (same_unit && job.to->value <= (job.from ? job.from->value : 0)) {
        const bool in_seconds = job.to->unit == app::Time::Unit::seconds;
        throw Error(
            ErrorCode::span_empty,
            fmt::format("the piece is empty: its end, {}, is not after its start; choose a later end",
                        in_seconds ? fmt::format("{} s", job.to->value) : fmt::format("frame {}", job.to->value)),
            {"from", "to"});
    }
    return span;
}

Selection select_between(const CutJob& job, const Footage& footage, app::Observer& observer) {
    const video::FrameSpan span = span_between(job, footage);
    return {span, place_by_packets(footage, job.search.input.rate, span.end, observer)};
}

// ---- The output's name

/// Whether the path is a folder or a name without extension.
bool is_open(const fs::path& path) {
    std::error_code none;
    return !path.has_filename() || fs::is_directory(path, none) || path.extension().empty();
}

/// The full file name: adds the fitting extension, and in a folder a name based on the first file.
fs::path named(const CutJob& job, const Selection& selection, const FootagePart& first) {
    if (!is_open(job.path)) return job.path;
    const video::Input input = video::open_input(first.file.path);
    const std::string_view ending = job.exact ? exact_extension() : video::extension_for(input, job.search.input.rate);
    if (ending.empty()) {
        throw Error(ErrorCode::input_unsuitable,
                    fmt::format("no container supports all streams of '{}'; encode the piece instead of copying it",
                                first.file.path),
                    {"exact"});
    }
    std::error_code none;
    const bool is_folder = !job.path.has_filename() || fs::is_directory(job.path, none);
    if (!is_folder) return fs::path(job.path) += ending;
    const std::string stem = fs::path(first.file.path).stem().string();
    const std::string what =
        job.event ? fmt::format("event-{}", *job.event) : fmt::format("{:.3f}s", selection.span.start);
    return job.path / fmt::format("{}-{}{}", stem, what, ending);
}

void check_output(const CutJob& job, const fs::path& path, const Footage& footage, app::Observer& observer) {
    for (const video::Segment& file : footage.recording.segments) check_not_input(path, file.path, "clip");
    if (!job.report.empty()) check_not_input(path, job.report, "report");
    const auto held = observer.guard();
    image::check_file_path(path);
}

// ---- Properties of the piece

/// Sets the clock of the footage from the first file of the piece.
void set_clock(const CutJob& job, const Footage& footage, const video::SegmentPlace& first, PieceJob& piece) {
    const auto file = std::ranges::find(footage.recording.segments, first.path, &video::Segment::path);
    const video::VideoInfo info = info_of(footage, *file, first.begin, job.search.input.rate);
    const app::StartTime& start = job.search.look.start_time;
    piece.clock = app::clock_of(start, info);
    if (start.from != app::StartTime::From::none) piece.created = info.created;
}

/// Logs the gaps, which the piece keeps.
void warn_of_gaps(const PieceJob& piece, app::Observer& observer) {
    double shown = piece.span.start;
    for (const FootagePart& part : piece.parts) {
        if (part.file.begin > shown + little) {
            observer.warn(fmt::format("'{}' has no frames from {:.3f} s to {:.3f} s; the piece keeps this gap",
                                      piece.name, shown, part.file.begin));
        }
        shown = std::max(shown, part.file.end);
    }
}

/// Writes the piece. Copies packets from the preceding key frame on, unless the piece must be exact.
/// \param stop request to stop; no file is then left
/// \returns false if it was stopped
/// \throws Error usage, io, not_video, limit
bool cut(const CutJob& asked, app::Observer& observer, const std::stop_token& stop) {
    const bool open = is_open(asked.path);
    if (!open) asked.exact ? check_exact(asked.path) : static_cast<void>(video::container_of(asked.path));
    const Footage footage = find_footage(asked.search.input);
    const CutJob job = in_seconds(asked, footage, observer);
    if (!open) check_output(job, job.path, footage, observer);
    const Selection selection = !job.event           ? select_between(job, footage, observer)
                                : job.report.empty() ? find_event(job, footage, observer)
                                                     : read_event(job, footage);
    PieceJob piece;
    piece.name = footage.recording.name;
    piece.camera = footage.recording.camera;
    piece.span = selection.span;
    piece.parts = parts_in(selection.places, selection.span);
    piece.input = job.search.input;
    piece.threads = job.search.fields.threads;
    piece.warns_of_early_end = !job.event;
    if (piece.parts.empty()) video::throw_empty(piece.name, piece.span, selection.places.back().end);
    set_clock(job, footage, selection.places.front(), piece);
    piece.path = named(job, selection, piece.parts.front());
    if (open) check_output(job, piece.path, footage, observer);
    warn_of_gaps(piece, observer);
    return job.exact ? encode_piece(piece, observer, stop) : copy_piece(piece, observer, stop);
}

namespace text {
constexpr Setting output{
    "output", "FILE", "the piece; its extension names the container, and is chosen if there is none, or for a folder"};
constexpr Setting event{
    "event", "N", "cut this event, by its number in the picture, the report and the page", {1, 1'000'000'000}};
constexpr Setting report{"report", "FILE", "read the events from this report of `vvr render --report`; no search"};
constexpr Setting from{"from", "TIME",
                       "cut from here; the beginning if not given; as --start, by the clock on the wall too"};
constexpr Setting to{"to", "TIME", "the first frame that is no longer in the piece; the end if not given"};
constexpr Setting margin{"margin", "TIME", "so much more before and after", {0, 3600}};
constexpr Setting exact{"exact", "",
                        "encode exactly these frames anew, without sound; else packets are copied from the key frame "
                        "before"};
}  // namespace text

class Cut final : public Command {
  public:
    void add_options(options::CommandLine& line) override {
        constexpr options::Group output = options::Group::output;
        line.path(output, job_.path, text::output,
                  {.letter = 'o',
                   .help = fmt::format(": {}", fmt::join(names_of(video::containers()), " ")),
                   .use = options::FileUse::written});
        line.value(output, text::event, "", [this](const std::string& given) {
            job_.event = options::parse_integer(given, static_cast<std::int64_t>(text::event.range.low),
                                                static_cast<std::int64_t>(text::event.range.high));
        });
        line.path(output, job_.report, text::report, {.use = options::FileUse::read});
        line.value(output, text::from, "",
                   [this](const std::string& given) { set(given, job_.from, job_.asked.start); });
        line.value(output, text::to, "", [this](const std::string& given) { set(given, job_.to, job_.asked.end); });
        line.duration(output, job_.margin, text::margin);
        line.flag(output, job_.exact, text::exact);
        line.exclude(text::event, text::from);
        line.exclude(text::event, text::to);
        line.exclude(text::report, text::from);
        line.exclude(text::report, text::to);
        // The options that decide which events exist, and their numbers.
        app::RenderJob& search = job_.search;
        options::add_event_options(line, output, search.output.events);
        options::add_input_options(
            line, search.input, "INPUT...",
            "a video file; files, folders, a pattern ('gate/*.mp4') or a list (.txt) of files that are one "
            "recording");
        options::add_name_options(line, search.input);
        options::add_join_option(line, search.input);
        options::add_start_time_option(line, search.look.start_time);
        options::add_span_options(line, search.fields.span);
        options::add_field_options(line, search.fields);
        options::add_preset_option(line, options::Group::run);
        options::add_thread_options(line, search.fields.threads);
        line.examples(
            {{"vvr cut clip.avi -o event.mkv --event 1", "the first event of the clip's picture"},
             {"vvr cut clip.avi -o piece.avi --from 0.5s --to 00:00:01.5", "a piece, copied from the key frame before"},
             {"vvr cut clip.avi -o exact.mp4 --from 5f --to 15f --exact", "exactly these frames, encoded again"}});
    }

    cli::ExitStatus run(const options::CommandLine&, const cli::Environment& environment) override {
        app::require_input(job_.search.input);
        if (job_.path.empty())
            throw Error(ErrorCode::output_missing, "no output given; name the file for the piece with -o FILE");
        if (!job_.event && !job_.from && !job_.to && !job_.asked.start && !job_.asked.end) {
            throw Error(ErrorCode::usage,
                        "no piece chosen; choose one with --event N, or with --from TIME and --to TIME");
        }
        cli::Console console(environment);
        const std::stop_source stop;
        environment.signals.set_exit_hook([stop]() mutable { stop.request_stop(); });
        if (!cut(job_, console, stop.get_token())) {
            // A signal has stopped it, and is about to end the program.
            for (;;) std::this_thread::sleep_for(std::chrono::seconds(1));
        }
        environment.signals.set_exit_hook({});
        return cli::ExitStatus::done;
    }

  private:
    /// Stores a time of the clip or a wall-clock time.
    static void set(const std::string& given, std::optional<app::Time>& time,
                    std::optional<video::RequestedTime>& asked) {
        const auto place = options::parse_place(given);
        time = std::holds_alternative<app::Time>(place) ? std::optional(std::get<app::Time>(place)) : std::nullopt;
        asked = time ? std::nullopt : std::optional(std::get<video::RequestedTime>(place));
    }

    CutJob job_;
};

}  // namespace

std::unique_ptr<Command> make_cut() {
    return std::make_unique<Cut>();
}

}  // namespace vvr::commands
