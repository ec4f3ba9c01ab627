#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/video/asked_time.h"
#include "core/video/frame_source.h"

namespace vvr::video {

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
    RequestedSpan asked{};          ///< limits by the clock on the wall, until `resolve` makes them seconds

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
