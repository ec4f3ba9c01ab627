#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/wall_clock.h"
#include "core/media/frame_source.h"

// Parts of a clip, as requested by the user in seconds, frames or wall-clock time.
namespace vvr::media {

struct FrameSpan;

/// A requested wall-clock time.
struct RequestedTime {
    std::int64_t seconds = 0;  ///< since 1970-01-01 00:00 on that clock; since midnight if not `dated`
    bool dated = false;        ///< false = a time of day, which means its next occurrence
    std::string text{};        ///< as the user wrote it

    friend bool operator==(const RequestedTime&, const RequestedTime&) = default;
};

/// A half-open interval of each day. It spans midnight if it ends before it begins.
struct DayPart {
    std::int64_t begin = 0;  ///< seconds since midnight
    std::int64_t end = 0;    ///< seconds since midnight, excluded
    std::string text{};      ///< as the user wrote it

    friend bool operator==(const DayPart&, const DayPart&) = default;
};

/// Requested limits of a span in wall-clock time. They take effect with `resolve`.
struct RequestedSpan {
    std::optional<RequestedTime> start{};
    std::optional<RequestedTime> end{};
    std::optional<DayPart> between{};

    friend bool operator==(const RequestedSpan&, const RequestedSpan&) = default;
};

/// Converts a wall-clock time to seconds of the clip.
/// \param from earliest result for a time of day, seconds of the clip
double seconds_of(const RequestedTime& asked, const Clock& clock, double from = 0);

/// Returns the clip's clock.
/// \param setting the setting that needs the clock, for the message
/// \param given the setting's value, for the message
/// \throws Error usage if the clock is unknown
const Clock& require_clock(const WallClock& clock, const VideoInfo& info, std::string_view setting,
                           std::string_view given);

/// Converts the wall-clock limits of a span to seconds of the clip.
/// \throws Error usage if the clock is unknown, or if the clip has no part of the requested times
FrameSpan resolve(FrameSpan span, const WallClock& clock, const VideoInfo& info);

/// The wall-clock times of a span: "2026-11-21 22:00:00 to 23:00:00 (by file name)". Empty for a whole clip or if the
/// clock is unknown.
std::string day_times_of(const FrameSpan& span, const WallClock& clock, const VideoInfo& info);

/// A part of a clip: the frames within all limits.
struct FrameSpan {
    double start = 0;                    ///< seconds
    std::optional<double> end{};         ///< seconds, excluded
    std::int64_t first = 0;              ///< frame index
    std::optional<std::int64_t> stop{};  ///< frame index, excluded

    /// A half-open interval in seconds.
    struct Part {
        double begin = 0;
        double end = 0;

        friend bool operator==(const Part&, const Part&) = default;
    };
    std::vector<Part> parts{};  ///< ascending; only frames in one of these; empty = all
    RequestedSpan asked{};      ///< wall-clock limits that `resolve` converts

    friend bool operator==(const FrameSpan&, const FrameSpan&) = default;
};

/// Whether a frame comes before the span.
bool is_before(const FrameSpan& span, std::int64_t index, double pts);

/// Whether a frame, and so every later frame, comes after the span.
bool is_past(const FrameSpan& span, std::int64_t index, double pts);

/// Whether a frame within the limits lies between two parts.
bool is_between_parts(const FrameSpan& span, double pts);

/// Why a stretch of a clip, in seconds, has no frames: what is known of it; "left out" if they were not requested; "no
/// footage" between two files of a recording, as the camera may record only motion; else "no signal".
/// \param files of the recording; empty for a single file or a stream
std::string reason_for_gap(const FrameSpan& span, std::span<const SegmentPlace> files,
                           std::span<const condition::Interval> known, double begin, double end);

/// The span for messages: "from 2 s to frame 80".
std::string text_of(const FrameSpan& span);

/// Number of frames in a span, estimated from the clip's header. 0 = unknown.
std::int64_t expected_frames(const VideoInfo& info, const FrameSpan& span);

}  // namespace vvr::media
