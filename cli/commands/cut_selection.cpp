#include "cli/commands/cut_selection.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "cli/excerpt/piece.h"
#include "cli/observe/identify.h"
#include "cli/observe/observe.h"
#include "cli/plan/input.h"
#include "cli/plan/make_plan.h"
#include "core/base/error.h"
#include "core/base/setting.h"
#include "core/fields/filter.h"
#include "core/media/container.h"
#include "core/media/demuxer.h"
#include "core/media/input.h"

namespace vvr::commands {

namespace {

// ---- An event

const app::PieceEvent& choose_event(const CutJob& job, const std::vector<app::PieceEvent>& events,
                                    const std::string& where) {
    const auto found = std::ranges::find(events, *job.event, &app::PieceEvent::number);
    if (found != events.end()) return *found;
    // In the report of a series, numbers are in the order in which the pictures showed the events.
    const std::int64_t most = events.empty() ? 0 : std::ranges::max(events, {}, &app::PieceEvent::number).number;
    const auto count = std::ssize(events);
    const std::string what = count == 0   ? "has no events"
                             : count == 1 ? fmt::format("has 1 event; choose {}", most)
                                          : fmt::format("has {} events; choose 1 to {}", count, most);
    throw Error(ErrorCode::event_unknown, fmt::format("event {}: '{}' {}", *job.event, where, what), {"event"});
}

Selection find_event(const CutJob& job, const app::Footage& footage, app::Observer& observer) {
    app::validate(job.search);
    const fields::FilterRow& filter = *job.search.fields.filter;
    if (!filter.traits.shows_object) {
        throw Error(ErrorCode::options_conflict,
                    fmt::format("filter '{}' does not mark objects, so there are no events; choose another filter",
                                filter.name),
                    {"filter"});
    }
    auto detector = app::open_detector(job.search.detector);
    const app::OpenedFields fields = app::open_fields(job.search);
    app::RenderJob search = job.search;
    search.look.show = {};
    const app::Plan plan = app::make_plan(std::move(search), fields.facts(), app::Purpose::search, std::move(detector));
    std::vector<app::PieceEvent> events;
    const app::Observation seen = app::observe(plan, *fields.source, observer);
    const app::VideoScale scale(plan.read.clip.field_size, seen.info.size);
    for (const tracking::Event& event : seen.events->events) {
        events.push_back(app::piece_event(event, std::ssize(events) + 1, scale));
    }
    const app::PieceEvent& event = choose_event(job, events, footage.recording.name);
    const media::FrameSpan span = app::span_around(event.first, event.last, job.margin);
    // A search that ended early does not know the files after that, which the margin may reach into.
    std::vector<media::SegmentPlace> places = fields.source->info().segments;
    if (places.empty() || places.back().path != footage.recording.segments.back().path) {
        places = app::place_by_packets(footage, span.end, observer);
    }
    return {span, std::move(places), event, events, plan.output.settings, {}, app::unseen_of(plan, seen)};
}

Selection read_event(const CutJob& job, const app::Footage& footage) {
    const app::ReportedEvents reported = app::read_events(job.report);
    const app::PieceEvent& event = choose_event(job, reported.events, job.report.string());
    return {app::span_around(event.first, event.last, job.margin),
            app::place_by_report(footage, reported, event, job.margin, job.report.string()),
            event,
            reported.events,
            reported.settings,
            reported.camera,
            reported.unseen};
}

// ---- Between two times

/// Checks that a limit of the piece may be a frame.
void check_frame(const CutJob& job, const app::Footage& footage, std::int64_t frame, const Setting& setting) {
    if (frame == 0) return;
    if (job.margin > 0) {
        throw Error(
            ErrorCode::options_conflict,
            fmt::format("margin needs times in seconds, but {} {}f is a frame number; give a time such as 12.5s",
                        setting.name, frame),
            {"margin"});
    }
    if (footage.recording.segments.size() == 1) return;
    throw Error(ErrorCode::option_value,
                fmt::format("{} {}f is a frame number, which is unknown in a recording of several files until it is "
                            "decoded; give a time such as 12.5s",
                            setting.name, frame),
                {setting.name});
}

media::FrameSpan span_between(const CutJob& job, const app::Footage& footage) {
    media::FrameSpan span = job.search.fields.span;
    check_frame(job, footage, span.first, setting::start);
    check_frame(job, footage, span.stop.value_or(0), setting::end);
    const bool empty = (span.end && span.first == 0 && *span.end <= span.start) ||
                       (span.stop && span.start == 0 && *span.stop <= span.first);
    if (empty) {
        throw Error(ErrorCode::span_empty,
                    fmt::format("the piece is empty: its end, {}, is not after its start; choose a later end",
                                span.end ? fmt::format("{} s", *span.end) : fmt::format("frame {}", *span.stop)),
                    {setting::start.name, setting::end.name});
    }
    span.start = std::max(0.0, span.start - job.margin);
    if (span.end) *span.end += job.margin;
    return span;
}

Selection select_between(const CutJob& job, const app::Footage& footage, app::Observer& observer) {
    const media::FrameSpan span = span_between(job, footage);
    return {span, app::place_by_packets(footage, span.end, observer)};
}

}  // namespace

media::VideoInfo info_of(const app::Footage& footage, const footage::Segment& file, double begin) {
    const media::ClipHeader header = media::header_of(
        media::Demuxer(media::open_input(file.path), media::Demuxer::Kind::video, footage.recording.rate));
    const std::int64_t before = std::llround(begin);
    media::VideoInfo info;
    info.name = footage.recording.name;
    info.duration = begin + header.length;
    if (file.begin) info.began = *file.begin - before;
    info.began_source = file.begin_source;
    if (header.created) info.created = *header.created - before;
    return info;
}

CutJob in_seconds(CutJob job, const app::Footage& footage, app::Observer& observer) {
    media::FrameSpan& span = job.search.fields.span;
    if (job.event || (!span.asked.start && !span.asked.end)) return job;
    media::VideoInfo info = info_of(footage, footage.recording.segments.front(), 0);
    info.duration = 0;  // it is that of the first file
    const WallClock known = app::clock_of(job.search.look.start_time, info);
    const std::optional<media::RequestedTime> start = span.asked.start;
    span = media::resolve(span, known, info);
    if (start && media::seconds_of(*start, *known) < 0) {
        observer.warn(
            fmt::format("'{}' begins at {}, later than the requested start of the piece", info.name, known->iso(0)));
    }
    return job;
}

Selection select_piece(const CutJob& job, const app::Footage& footage, app::Observer& observer) {
    if (!job.event) return select_between(job, footage, observer);
    return job.report.empty() ? find_event(job, footage, observer) : read_event(job, footage);
}

}  // namespace vvr::commands
