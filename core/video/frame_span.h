#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/video/frame_source.h"

// Stretches of a clip as people ask for them: by the clock on the wall that was there.
namespace vvr::video {

struct FrameSpan;

/// A moment by the clock on the wall.
struct RequestedTime {
    std::int64_t seconds = 0;  ///< since 1970-01-01 00:00 on that clock; of a time of day, since midnight
    bool dated = false;        ///< else it is a time of day, and the next time that the clock shows it is meant
    std::string text{};        ///< as it was asked for

    friend bool operator==(const RequestedTime&, const RequestedTime&) = default;
};

/// A part of each day, over midnight where it ends before it begins.
struct DayPart {
    std::int64_t begin = 0;  ///< seconds since midnight
    std::int64_t end = 0;    ///< itself left out
    std::string text{};      ///< as it was asked for

    friend bool operator==(const DayPart&, const DayPart&) = default;
};

/// Limits of a span by the clock on the wall. They mean nothing before `resolve`.
struct RequestedSpan {
    std::optional<RequestedTime> start{};
    std::optional<RequestedTime> end{};
    std::optional<DayPart> between{};

    friend bool operator==(const RequestedSpan&, const RequestedSpan&) = default;
};

/// The second of the clip that a moment means.
/// \param from the second from which on a time of day is looked for
double seconds_of(const RequestedTime& asked, const Clock& clock, double from = 0);

/// The clock, where it is known.
/// \param setting that needs it, and what it was given
/// \throws Error usage
const Clock& require_clock(const WallClock& clock, const VideoInfo& info, std::string_view setting,
                           std::string_view given);

/// The same span with what was asked for by the clock as seconds of the clip.
/// \throws Error usage where the clock isn't known, or the clip has nothing of what was asked for
FrameSpan resolve(FrameSpan span, const WallClock& clock, const VideoInfo& info);

/// Which times of day a span means: "2026-11-21 22:00:00 to 23:00:00 (by file name)"; empty where it is a whole clip,
/// or nobody knows.
std::string day_times_of(const FrameSpan& span, const WallClock& clock, const VideoInfo& info);

/// A stretch of a clip: the frames within all limits.
struct FrameSpan {
    double start = 0;                    ///< seconds
    std::optional<double> end{};         ///< seconds; itself left out
    std::int64_t first = 0;              ///< a frame's number
    std::optional<std::int64_t> stop{};  ///< a frame's number; itself left out

    /// A stretch of seconds, its end left out.
    struct Part {
        double begin = 0;
        double end = 0;

        friend bool operator==(const Part&, const Part&) = default;
    };
    std::vector<Part> parts{};  ///< only frames in one of these, in order; empty = all
    RequestedSpan asked{};      ///< limits by the clock on the wall, until `resolve` makes them seconds

    friend bool operator==(const FrameSpan&, const FrameSpan&) = default;
};

/// Whether a frame comes before all of the span.
bool is_before(const FrameSpan& span, std::int64_t index, double pts);

/// Whether a frame, and so all that follow it, come after the span.
bool is_past(const FrameSpan& span, std::int64_t index, double pts);

/// Whether a frame within the limits lies between two parts.
bool is_between_parts(const FrameSpan& span, double pts);

/// "from 2 s to frame 80"
std::string text_of(const FrameSpan& span);

/// How many frames a span has as far as the clip's header tells; 0 = unknown.
std::int64_t expected_frames(const VideoInfo& info, const FrameSpan& span);

}  // namespace vvr::video
