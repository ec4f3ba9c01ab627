#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/video/demuxer.h"
#include "core/video/frame_source.h"

namespace vvr::video {

/// Describes the video stream by its container, and by the display size of its first frame.
VideoInfo describe(const Demuxer& demuxer, const std::string& name, const AVFrame& first);

/// Longest plausible duration of a clip, seconds: ten years. A header with more is wrong.
inline constexpr double longest_clip = 10 * 365.25 * 86'400;

/// What a container's header tells without decoding.
struct ClipHeader {
    double length = 0;                      ///< seconds; 0 = unknown
    double implausible_length = 0;          ///< duration in the header if above `longest_clip`, seconds
    std::int64_t frames = 0;                ///< estimate; 0 = unknown
    Size picture;                           ///< stored size
    double rate = 0;                        ///< frames per second; 0 = unknown
    std::optional<std::int64_t> created{};  ///< seconds since 1970 (UTC)
};

ClipHeader header_of(const Demuxer& demuxer);

/// The orientation in the container: the nearest quarter turn, with or without a flip.
Orientation orientation_of(const AVStream& stream);

}  // namespace vvr::video
