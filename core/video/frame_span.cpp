#include "core/video/frame_span.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace vvr::video {

namespace {

/// A time typed with three decimals means the frame that it names, whose own time has more of them.
constexpr double slack = 0.0005;

}  // namespace

bool is_before(const FrameSpan& span, std::int64_t index, double pts) {
    return index < span.first || pts < span.start - slack;
}

bool is_past(const FrameSpan& span, std::int64_t index, double pts) {
    return (span.stop && index >= *span.stop) || (span.end && pts >= *span.end - slack);
}

bool is_between_parts(const FrameSpan& span, double pts) {
    if (span.parts.empty()) return false;
    return std::ranges::none_of(
        span.parts, [pts](const FrameSpan::Part& part) { return pts >= part.begin - slack && pts < part.end - slack; });
}

std::string text_of(const FrameSpan& span) {
    // Milliseconds, without what adding fractions leaves in the fifteenth place.
    const auto shown = [](double seconds) { return std::round(seconds * 1000) / 1000; };
    const std::string from =
        span.first > 0 ? fmt::format("frame {}", span.first) : fmt::format("{} s", shown(span.start));
    if (span.stop) return fmt::format("from {} to frame {}", from, *span.stop);
    if (span.end) return fmt::format("from {} to {} s", from, shown(*span.end));
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

}  // namespace vvr::video
