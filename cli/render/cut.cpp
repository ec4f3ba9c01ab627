#include "cli/render/cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/render/event_times.h"
#include "cli/render/open_fields.h"
#include "cli/render/render_clip.h"
#include "cli/render/shown_name.h"
#include "cli/render/tell_problems.h"
#include "core/error.h"
#include "core/fields/filter.h"
#include "core/image/atomic_file.h"
#include "core/image/film_encoder.h"
#include "core/store/manifest.h"
#include "core/video/packet_copy.h"
#include "core/video/picture_list.h"
#include "core/video/piece.h"
#include "core/video/scaler.h"
#include "core/words.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;

/// Thrown by the function that writes the file, so that nothing of it stays.
struct Stopped {};

/// How the frames of an exact piece are encoded. Frames do not refer to later ones, so that times begin at 0.
struct Encoding {
    std::string_view muxer;
    const char* encoder;
    const char* options;
};

/// The first of a container whose encoder is installed is taken.
constexpr const char* h264 = "crf=18,preset=veryfast,bf=0,x264-params=log=-1,colorspace=smpte170m,color_range=tv";
constexpr std::array encodings{
    Encoding{"mp4", "libx264", h264},
    Encoding{"mov", "libx264", h264},
    Encoding{"matroska", "libx264", h264},
    Encoding{"mp4", "mpeg4", "b=12000000"},
    Encoding{"mov", "mpeg4", "b=12000000"},
    Encoding{"matroska", "mpeg4", "b=12000000"},
    Encoding{"webm", "libvpx-vp9", "crf=28,b=0,cpu-used=5,deadline=realtime"},
    Encoding{"webm", "libvpx", "crf=10,b=20000000,cpu-used=5,deadline=realtime"},
};

const Encoding& encoding_for(const fs::path& path) {
    const ContainerRow& container = container_of(path);
    const auto fits = [&](const Encoding& e) { return e.muxer == container.muxer && has_encoder(e.encoder); };
    if (const auto found = std::ranges::find_if(encodings, fits); found != encodings.end()) return *found;
    std::vector<std::string_view> others;
    for (const ContainerRow& row : containers()) {
        if (std::ranges::find(encodings, row.muxer, &Encoding::muxer) != encodings.end()) others.push_back(row.name);
    }
    throw Error(ErrorKind::usage,
                fmt::format("cannot write '{}': an exact piece can't be a {}, or its encoder is not installed; choose "
                            "{}",
                            path.string(), container.name, fmt::join(others, ", ")),
                {"exact"});
}

/// Only a file with times can be cut.
void check_input(const std::string& name) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::usage, fmt::format("'{}' is {}; give the file of a clip", name, what));
    };
    std::error_code none;
    if (name == "-") refuse("stdin, which can't be cut");
    if (is_data_folder(name)) refuse("what `vvr extract` wrote, and has no video in it");
    if (fs::is_regular_file(name, none)) return;
    if (list_pictures(name)) refuse("a sequence of pictures, not a clip");
    if (is_url(name)) refuse("an address; save it to a file first");
    if (fs::exists(name, none)) refuse("not a regular file");
}

void check_not_input(const fs::path& path, const fs::path& input, std::string_view what) {
    std::error_code none;
    if (!fs::equivalent(path, input, none)) return;
    throw Error(ErrorKind::usage, fmt::format("'{}' is the {} itself, '{}'; give the piece a name of its own",
                                              path.string(), what, input.string()));
}

/// Times as people type them.
double rounded(double seconds) {
    return std::round(seconds * 1000) / 1000;
}

std::vector<EventTimes> search(const RenderJob& asked, Observer& observer) {
    validate(asked);
    if (!find_filter(asked.fields.filter).traits.shows_object) {
        throw Error(ErrorKind::usage,
                    fmt::format("filter: '{}' marks no objects, so there are no events; choose another filter",
                                asked.fields.filter),
                    {"filter"});
    }
    const OpenedFields fields = open_fields(asked);
    RenderJob job = asked;
    job.look.show = {};
    std::vector<EventTimes> times;
    for (const Event& event : find_events(job, *fields.source, observer)) {
        times.push_back({event.first.seconds, event.last.seconds});
    }
    return times;
}

std::vector<EventTimes> events_of(const CutJob& job, const std::string& input, Observer& observer) {
    if (job.report.empty()) return search(job.search, observer);
    ReportedEvents events = read_events(job.report);
    if (fs::path(events.clip).filename() != fs::path(input).filename()) {
        observer.warn(fmt::format("report '{}' is about '{}', and the clip is '{}'", job.report.string(),
                                  shown_name(events.clip), input));
    }
    return std::move(events.times);
}

FrameSpan span_of_event(const CutJob& job, const std::string& input, Observer& observer) {
    const std::vector<EventTimes> events = events_of(job, input, observer);
    const auto count = std::ssize(events);
    if (*job.event < 1 || *job.event > count) {
        const std::string where = job.report.empty() ? input : job.report.string();
        const std::string what = count == 0   ? "has no events"
                                 : count == 1 ? "has 1 event; choose that"
                                              : fmt::format("has {} events; choose 1 to {}", count, count);
        throw Error(ErrorKind::usage, fmt::format("event: there is no event {}: '{}' {}", *job.event, where, what),
                    {"event"});
    }
    const EventTimes& event = events[static_cast<std::size_t>(*job.event - 1)];
    // The end of a span is left out of it, and an event's last frame belongs to it.
    constexpr double little = 0.002;  // seconds; less than any frame lasts, more than times are rounded by
    FrameSpan span;
    span.start = rounded(std::max(0.0, event.first - job.margin));
    span.end = rounded(event.last + job.margin) + little;
    return span;
}

void check_margin(const CutJob& job, const Time& time, std::string_view option) {
    if (job.margin == 0 || time.unit == Time::Unit::seconds) return;
    throw Error(
        ErrorKind::usage,
        fmt::format("margin is in seconds, and {} {} is a frame; give a time such as 12.5s", option, time.value),
        {"margin"});
}

FrameSpan span_between(const CutJob& job) {
    FrameSpan span;
    if (job.from) {
        check_margin(job, *job.from, "from");
        if (job.from->unit == Time::Unit::seconds) span.start = std::max(0.0, job.from->value - job.margin);
        if (job.from->unit == Time::Unit::frames) span.first = static_cast<std::int64_t>(job.from->value);
    }
    if (job.to) {
        check_margin(job, *job.to, "to");
        if (job.to->unit == Time::Unit::seconds) span.end = job.to->value + job.margin;
        if (job.to->unit == Time::Unit::frames) span.stop = static_cast<std::int64_t>(job.to->value);
    }
    const double least = job.to ? job.to->value : 0;
    const bool same_unit = job.to && (!job.from || job.from->unit == job.to->unit);
    if (same_unit && least <= (job.from ? job.from->value : 0)) {
        throw Error(ErrorKind::usage,
                    fmt::format("the piece is empty: it ends at {}{} and does not begin before that", least,
                                job.to->unit == Time::Unit::seconds ? " s" : ", a frame,"),
                    {"from", "to"});
    }
    return span;
}

void warn_of_end(Observer& observer, const std::string& name, double end) {
    observer.warn(fmt::format("'{}' ends at {:.3f} s, before the piece was to end", name, end));
}

bool copy(const CutJob& job, const std::string& name, const FrameSpan& span, Observer& observer,
          const std::stop_token& stop) {
    const Input input = open_input(name);
    const double rate = job.search.input.rate;
    const Piece piece = find_piece(input, rate, span);
    Copied copied;
    try {
        const auto held = observer.guard();
        replace_file(job.path, [&](const WriteAt& write_at) {
            copied = copy_piece(input, rate, piece, job.path, write_at, [&] { return stop.stop_requested(); });
            if (copied.stopped) throw Stopped();
        });
    } catch (const Stopped&) {
        return false;
    }
    if (piece.ends_early && !job.event) warn_of_end(observer, name, piece.end);
    if (piece.damaged > 0) {
        observer.warn(
            fmt::format("'{}': {} of the piece copied as they are", name, counted(piece.damaged, "damaged packet")));
    }
    if (!copied.left_out.empty()) {
        observer.info(fmt::format("'{}': left out, as it is neither picture, sound nor text: {}", job.path.string(),
                                  fmt::join(copied.left_out, ", ")));
    }
    const double before = piece.wanted - piece.begin;
    const std::string lead = before < 0.0005 ? "a key frame, where the piece does"
                                             : fmt::format("the key frame {:.3f} s before the piece", before);
    observer.info(fmt::format("'{}': {} copied, {:.3f} s to {:.3f} s of '{}'; it begins with {}", job.path.string(),
                              counted(copied.packets, "frame"), piece.begin, piece.end, name, lead));
    return true;
}

/// Frames of a clip from a span's first on.
std::unique_ptr<DecodedFrame> first_of(FrameSource& clip, const FrameSpan& span) {
    if (span.start > 0) clip.seek(span.start - 1);
    auto frame = clip.next();
    while (frame && is_before(span, frame->index, frame->pts)) frame = clip.next();
    return frame;
}

struct Encoded {
    std::int64_t frames = 0;
    double begin = 0;
    double end = 0;
    bool ends_early = false;
};

Encoded encode(const CutJob& job, FrameSource& clip, std::unique_ptr<DecodedFrame> frame, const FrameSpan& span,
               const WriteAt& write_at, Observer& observer, const std::stop_token& stop) {
    constexpr int ticks = 90'000;
    constexpr int default_rate = 25;
    const Encoding& encoding = encoding_for(job.path);
    const double given = clip.info().rate;
    const int rate = given > 0 ? static_cast<int>(std::clamp(std::round(given), 1.0, 1000.0)) : default_rate;
    FilmEncoder film({std::string(encoding.muxer), encoding.encoder, encoding.options}, job.path.string(),
                     clip.info().size, ticks, rate, 2 * rate, write_at);
    Scaler scale(clip);
    const std::int64_t expected = expected_frames(clip.info(), span);
    Encoded encoded{0, frame->pts, frame->pts, false};
    std::int64_t last_tick = -1;
    for (; frame && !is_past(span, frame->index, frame->pts); frame = clip.next()) {
        if (stop.stop_requested()) throw Stopped();
        // Two frames of one time are shown one after the other.
        last_tick = std::max(last_tick + 1, std::int64_t{std::llround((frame->pts - encoded.begin) * ticks)});
        encoded.end = frame->pts;
        film.add(scale(*frame).colour, last_tick);
        observer.frames(++encoded.frames, expected);
    }
    film.finish();
    const double length = given > 0 ? 1 / given : 0;
    encoded.ends_early = !frame && span.end && encoded.end + length + 0.002 < *span.end;
    return encoded;
}

bool cut_exactly(const CutJob& job, const std::string& name, const FrameSpan& span, Observer& observer,
                 const std::stop_token& stop) {
    InputOptions options = job.search.input;
    options.field_size = {-1, -1};
    std::vector<std::string> warnings;
    const auto clip = open_clip(options, true, job.search.fields.threads, warnings);
    tell_problems(warnings, {}, observer);
    auto frame = first_of(*clip, span);
    if (!frame || is_past(span, frame->index, frame->pts)) throw_empty(name, span, std::nullopt);
    Encoded encoded;
    try {
        const auto held = observer.guard();
        replace_file(job.path, [&](const WriteAt& write_at) {
            encoded = encode(job, *clip, std::move(frame), span, write_at, observer, stop);
        });
    } catch (const Stopped&) {
        return false;
    }
    if (encoded.ends_early && !job.event) warn_of_end(observer, name, encoded.end);
    if (clip->damaged() > 0) {
        observer.warn(fmt::format("'{}': {}; the piece has the frames that decoded", name,
                                  counted(clip->damaged(), "damaged packet")));
    }
    observer.info(fmt::format("'{}': {} encoded anew without sound, {:.3f} s to {:.3f} s of '{}'", job.path.string(),
                              counted(encoded.frames, "frame"), encoded.begin, encoded.end, name));
    return true;
}

}  // namespace

bool cut(const CutJob& job, Observer& observer, const std::stop_token& stop) {
    const std::string& name = only_input(job.search.input);
    container_of(job.path);
    if (job.exact) encoding_for(job.path);
    check_input(name);
    check_not_input(job.path, name, "clip");
    if (!job.report.empty()) check_not_input(job.path, job.report, "report");
    {
        const auto held = observer.guard();
        check_file_path(job.path);
    }
    const FrameSpan span = job.event ? span_of_event(job, name, observer) : span_between(job);
    return job.exact ? cut_exactly(job, name, span, observer, stop) : copy(job, name, span, observer, stop);
}

}  // namespace vvr
