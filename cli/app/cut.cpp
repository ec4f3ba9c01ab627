#include "cli/app/cut.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "cli/app/footage.h"
#include "cli/app/input.h"
#include "cli/app/observe.h"
#include "cli/app/write_piece.h"
#include "core/base/error.h"
#include "core/fields/filter.h"
#include "core/image/atomic_file.h"
#include "core/video/container.h"
#include "core/video/packet_range.h"

namespace vvr::app {

namespace {

namespace fs = std::filesystem;

constexpr double little = 0.002;  // seconds; shorter than any frame, longer than the rounding of times

void check_not_input(const fs::path& path, const fs::path& input, std::string_view what) {
    std::error_code none;
    if (!fs::equivalent(path, input, none)) return;
    throw Error(ErrorCode::output_replaces_input,
                fmt::format("'{}' is the {} itself, '{}'; give the piece a name of its own", path.string(), what,
                            input.string()));
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
                             : count == 1 ? "has 1 event; choose that"
                                          : fmt::format("has {} events; choose 1 to {}", count, count);
    throw Error(ErrorCode::event_unknown, fmt::format("event: there is no event {}: '{}' {}", *job.event, where, what),
                {"event"});
}

video::FrameSpan span_of(const EventTimes& event, double margin) {
    // A span's end is exclusive, but the event's last frame is part of it.
    video::FrameSpan span;
    span.start = rounded(std::max(0.0, event.first - margin));
    span.end = rounded(event.last + margin) + little;
    return span;
}

Selection find_event(const CutJob& job, const Footage& footage, Observer& observer) {
    validate(job.search);
    const fields::FilterRow& filter = *job.search.fields.filter;
    if (!filter.traits.shows_object) {
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("filter: '{}' marks no objects, so there are no events; choose another filter", filter.name),
            {"filter"});
    }
    const OpenedFields fields = open_fields(job.search);
    RenderJob search = job.search;
    search.look.show = {};
    const Plan plan = make_plan(std::move(search), fields.facts(), Purpose::search);
    std::vector<EventTimes> events;
    const Observation seen = observe(plan, *fields.source, observer);
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
CutJob in_seconds(CutJob job, const Footage& footage, Observer& observer) {
    if (!job.asked.start && !job.asked.end) return job;
    const video::VideoInfo info = info_of(footage, footage.recording.segments.front(), 0, job.search.input.rate);
    const WallClock known = clock_of(job.search.look.start_time, info);
    const auto seconds = [&](const video::RequestedTime& asked, std::string_view setting, double from) {
        return Time{video::seconds_of(asked, video::require_clock(known, info, setting, asked.text), from),
                    Time::Unit::seconds};
    };
    if (job.asked.start) {
        job.from = seconds(*job.asked.start, "from", 0);
        if (job.from->value < 0) {
            observer.warn(fmt::format("'{}' begins at {}, after the piece was to begin", info.name, known->iso(0)));
            job.from->value = 0;
        }
    }
    const double begin = job.from && job.from->unit == Time::Unit::seconds ? job.from->value : 0;
    if (job.asked.end) job.to = seconds(*job.asked.end, "to", begin + 1e-3);
    return job;
}

void check_unit(const CutJob& job, const Footage& footage, const Time& time, std::string_view option) {
    if (time.unit == Time::Unit::seconds || time.value == 0) return;
    if (job.margin > 0) {
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("margin is in seconds, and {} {} is a frame; give a time such as 12.5s", option, time.value),
            {"margin"});
    }
    if (footage.is_single) return;
    throw Error(ErrorCode::option_value,
                fmt::format("{} {} is a frame, and the frames of a recording of several files are not counted without "
                            "decoding it; give a time such as 12.5s",
                            option, time.value),
                {option});
}

video::FrameSpan span_between(const CutJob& job, const Footage& footage) {
    video::FrameSpan span;
    if (job.from) {
        check_unit(job, footage, *job.from, "from");
        if (job.from->unit == Time::Unit::seconds) span.start = std::max(0.0, job.from->value - job.margin);
        if (job.from->unit == Time::Unit::frames) span.first = static_cast<std::int64_t>(job.from->value);
    }
    if (job.to) {
        check_unit(job, footage, *job.to, "to");
        if (job.to->unit == Time::Unit::seconds) span.end = job.to->value + job.margin;
        if (job.to->unit == Time::Unit::frames) span.stop = static_cast<std::int64_t>(job.to->value);
    }
    const double least = job.to ? job.to->value : 0;
    const bool same_unit = job.to && (!job.from || job.from->unit == job.to->unit);
    if (same_unit && least <= (job.from ? job.from->value : 0)) {
        throw Error(ErrorCode::span_empty,
                    fmt::format("the piece is empty: it ends at {}{} and does not begin before that", least,
                                job.to->unit == Time::Unit::seconds ? " s" : ", a frame,"),
                    {"from", "to"});
    }
    return span;
}

Selection select_between(const CutJob& job, const Footage& footage, Observer& observer) {
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
                    fmt::format("no container can hold all of '{}'; cut it exactly, which encodes the video anew",
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

void check_output(const CutJob& job, const fs::path& path, const Footage& footage, Observer& observer) {
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
    const StartTime& start = job.search.look.start_time;
    piece.clock = clock_of(start, info);
    if (start.from != StartTime::From::none) piece.created = info.created;
}

/// Logs the gaps, which the piece keeps.
void tell_gaps(const PieceJob& piece, Observer& observer) {
    double shown = piece.span.start;
    for (const FootagePart& part : piece.parts) {
        if (part.file.begin > shown + little) {
            observer.warn(
                fmt::format("'{}' has nothing from {:.3f} s to {:.3f} s", piece.name, shown, part.file.begin));
        }
        shown = std::max(shown, part.file.end);
    }
}

}  // namespace

bool cut(const CutJob& asked, Observer& observer, const std::stop_token& stop) {
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
    piece.tells_early_end = !job.event;
    if (piece.parts.empty()) video::throw_empty(piece.name, piece.span, selection.places.back().end);
    set_clock(job, footage, selection.places.front(), piece);
    piece.path = named(job, selection, piece.parts.front());
    if (open) check_output(job, piece.path, footage, observer);
    tell_gaps(piece, observer);
    return job.exact ? encode_piece(piece, observer, stop) : copy_piece(piece, observer, stop);
}

}  // namespace vvr::app
