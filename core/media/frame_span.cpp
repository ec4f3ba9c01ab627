#include "core/media/frame_span.h"

#include <algorithm>
#include <cmath>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"

namespace vvr::media {

namespace {

constexpr std::int64_t day = 86'400;

std::string on_clock(const Clock& clock, double seconds) {
    const auto shown = static_cast<std::time_t>(std::floor(clock.at(seconds) + 1e-6));
    return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(shown));
}

std::int64_t day_at(const Clock& clock, double seconds) {
    return static_cast<std::int64_t>(std::floor(clock.at(seconds) / static_cast<double>(day)));
}

/// The likely end in seconds, with a margin because headers are inaccurate.
double likely_end(const FrameSpan& span, const VideoInfo& info) {
    constexpr double unknown = 366.0 * day;
    constexpr double more = 60;
    if (span.end) return *span.end;
    return info.duration > 0 ? info.duration + more : unknown;
}

[[noreturn]] void refuse(std::string_view setting, std::string_view given, const Clock& clock, const VideoInfo& info) {
    const std::string end = info.duration > 0 ? fmt::format(" and ends at {}", on_clock(clock, info.duration)) : "";
    throw Error(ErrorCode::span_empty,
                fmt::format("{}: {} is outside '{}', which begins at {}{} ({}); choose a time within it", setting,
                            given, info.name, on_clock(clock, 0), end, row_of(clock.source).words),
                {setting});
}

std::vector<FrameSpan::Part> parts_of(const DayPart& asked, const Clock& clock, double begin, double end) {
    std::vector<FrameSpan::Part> parts;
    const std::int64_t over_midnight = asked.end <= asked.begin ? 1 : 0;
    for (std::int64_t date = day_at(clock, begin) - 1; date <= day_at(clock, end); ++date) {
        const FrameSpan::Part part{
            std::max(begin, clock.when(static_cast<double>(date * day + asked.begin))),
            std::min(end, clock.when(static_cast<double>((date + over_midnight) * day + asked.end)))};
        if (part.begin < part.end) parts.push_back(part);
    }
    return parts;
}

}  // namespace

double seconds_of(const RequestedTime& asked, const Clock& clock, double from) {
    if (asked.dated) return clock.when(static_cast<double>(asked.seconds));
    std::int64_t date = day_at(clock, from);
    double seconds = clock.when(static_cast<double>(date * day + asked.seconds));
    while (seconds < from) seconds = clock.when(static_cast<double>(++date * day + asked.seconds));
    return seconds;
}

const Clock& require_clock(const WallClock& clock, const VideoInfo& info, std::string_view setting,
                           std::string_view given) {
    if (clock) return *clock;
    const std::string_view more =
        info.created ? "; --start-time container uses the creation time in its container" : "";
    throw Error(ErrorCode::time_of_day_unknown,
                fmt::format("{} {}: the recording time of '{}' is unknown; set it with --start-time DATETIME, describe "
                            "its file name with --names, or give the time since its start, such as 1h30m{}",
                            setting, given, info.name, more),
                {setting, "start-time"});
}

FrameSpan resolve(FrameSpan span, const WallClock& known, const VideoInfo& info) {
    if (const auto& asked = span.asked.start) {
        const Clock& clock = require_clock(known, info, "start", asked->text);
        span.start = std::max(0.0, seconds_of(*asked, clock));
        if (info.duration > 0 && span.start >= likely_end({}, info)) {
            refuse("start", asked->text, clock, info);
        }
    }
    if (const auto& asked = span.asked.end) {
        const Clock& clock = require_clock(known, info, "end", asked->text);
        span.end = seconds_of(*asked, clock, span.start + 1e-3);
        if (*span.end <= 0) refuse("end", asked->text, clock, info);
        if (*span.end <= span.start) {
            throw Error(ErrorCode::span_empty,
                        fmt::format("end: {} is not after the start, {}; choose a later end", asked->text,
                                    on_clock(clock, span.start)),
                        {"end"});
        }
    }
    if (const auto& asked = span.asked.between) {
        const Clock& clock = require_clock(known, info, "between", asked->text);
        span.parts = parts_of(*asked, clock, span.start, likely_end(span, info));
        if (span.parts.empty()) refuse("between", asked->text, clock, info);
        span.start = span.parts.front().begin;
        span.end = span.parts.back().end;
        if (span.parts.size() == 1) span.parts.clear();
    }
    span.asked = {};
    return span;
}

std::string day_times_of(const FrameSpan& span, const WallClock& clock, const VideoInfo& info) {
    if (!clock || (span.start <= 0 && !span.end)) return {};
    std::string text = on_clock(*clock, span.start);
    const bool is_cut = span.end && (info.duration <= 0 || *span.end < info.duration);
    if (is_cut) {
        text += fmt::format(" to {}", on_clock(*clock, *span.end));
    } else if (info.duration > span.start) {
        text += fmt::format(" to the end at {}", on_clock(*clock, info.duration));
    } else {
        text += " to the end";
    }
    if (!span.parts.empty()) text += fmt::format(", in {}", counted(std::ssize(span.parts), "part"));
    const std::string& zone = clock->zone;
    return fmt::format("{} ({}{}{})", text, zone, zone.empty() ? "" : "; ", row_of(clock->source).words);
}

namespace {

/// Seconds. A time typed with three decimals must match a frame whose exact time has more.
}  // namespace

bool is_before(const FrameSpan& span, std::int64_t index, double pts) {
    return index < span.first || pts < span.start - time_tolerance;
}

bool is_past(const FrameSpan& span, std::int64_t index, double pts) {
    return (span.stop && index >= *span.stop) || (span.end && pts >= *span.end - time_tolerance);
}

bool is_between_parts(const FrameSpan& span, double pts) {
    if (span.parts.empty()) return false;
    return std::ranges::none_of(span.parts, [pts](const FrameSpan::Part& part) {
        return pts >= part.begin - time_tolerance && pts < part.end - time_tolerance;
    });
}

std::string reason_for_gap(const FrameSpan& span, std::span<const SegmentPlace> files,
                           std::span<const condition::Interval> known, double begin, double end) {
    constexpr double little = 1;  // seconds
    for (const condition::Interval& some : known) {
        if (some.begin < end && some.end > begin) return std::string(row_of(some.kind).words);
    }
    // What a file has of the stretch, as far as that was requested.
    const auto is_in_file = [&](double first, double last) {
        return std::ranges::any_of(files, [&](const SegmentPlace& file) {
            return std::min(file.end, last) - std::max(file.begin, first) > little / 2;
        });
    };
    const bool is_within =
        files.empty() ||
        (span.parts.empty() ? is_in_file(begin, end) : std::ranges::any_of(span.parts, [&](const auto& part) {
            return is_in_file(std::max(part.begin, begin), std::min(part.end, end));
        }));
    const std::string lacks = is_within ? "no signal" : "no footage";
    if (span.parts.empty()) return lacks;
    double asked = 0;
    for (const FrameSpan::Part& part : span.parts)
        asked += std::max(0.0, std::min(part.end, end) - std::max(part.begin, begin));
    if (end - begin - asked <= little) return lacks;
    return asked > little ? "left out, " + lacks : "left out";
}

std::string text_of(const FrameSpan& span) {
    const std::string from =
        span.first > 0 ? fmt::format("frame {}", span.first) : fmt::format("{} s", rounded(span.start));
    if (span.stop) return fmt::format("from {} to frame {}", from, *span.stop);
    if (span.end) return fmt::format("from {} to {} s", from, rounded(*span.end));
    return fmt::format("from {} to its end", from);
}

std::int64_t expected_frames(const VideoInfo& info, const FrameSpan& span) {
    if (info.frames <= 0 || span == FrameSpan{}) return info.frames;
    const auto frames = static_cast<double>(info.frames);
    const double rate = info.duration > 0 ? frames / info.duration : info.rate;
    double begin = static_cast<double>(span.first);
    double end = span.stop ? std::min(frames, static_cast<double>(*span.stop)) : frames;
    if (rate > 0) {
        begin = std::max(begin, span.start * rate);
        if (span.end) end = std::min(end, *span.end * rate);
    }
    double left_out = 0;  // seconds
    for (std::size_t i = 1; i < span.parts.size(); ++i) left_out += span.parts[i].begin - span.parts[i - 1].end;
    return std::llround(std::max(0.0, end - begin - left_out * rate));
}

}  // namespace vvr::media
