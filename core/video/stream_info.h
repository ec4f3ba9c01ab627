#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/video/demuxer.h"
#include "core/video/frame_source.h"

namespace vvr::video {

/// What the container says of the video stream, with the size of its first frame as it is to be seen.
VideoInfo describe(const Demuxer& demuxer, const std::string& name, const AVFrame& first);

/// Seconds that a clip may last: ten years. What is longer is no clip's length but a header that lies.
inline constexpr double longest_clip = 10 * 365.25 * 86'400;

/// What a container's header says of a clip, without a frame being decoded.
struct ClipHeader {
    double length = 0;                      ///< seconds; 0 = unknown
    double implausible_length = 0;          ///< seconds that it says instead, where no clip lasts so long
    std::int64_t frames = 0;                ///< estimate; 0 = unknown
    Size picture;                           ///< as it is stored
    double rate = 0;                        ///< frames per second; 0 = unknown
    std::optional<std::int64_t> created{};  ///< seconds since 1970 (UTC)
};

ClipHeader header_of(const Demuxer& demuxer);

/// How the container wants the stream's pictures turned: the nearest quarter turn, mirrored or not.
Orientation orientation_of(const AVStream& stream);

}  // namespace vvr::video
