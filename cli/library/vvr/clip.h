#pragma once

#include <cstdint>
#include <string>

namespace vvr {

/// Properties of a clip, from its container. Headers can be wrong: the numbers of frames and seconds are estimates.
struct ClipInfo {
    std::string container;         ///< short name of the format, for example "avi"
    std::string codec;             ///< short name of the codec, for example "h264"
    int width = 0;                 ///< pixels of a displayed frame, with square pixels
    int height = 0;                ///< pixels of a displayed frame, with square pixels
    double frames_per_second = 0;  ///< 0 = unknown
    double seconds = 0;            ///< 0 = unknown
    std::int64_t frames = 0;       ///< 0 = unknown
};

/// Opens a clip and decodes its first frame.
/// \param clip as INPUT of `vvr render`: a file, a URL, a folder or pattern of pictures
/// \throws Failure io when it can't be read, not_video when no frame decodes, limit
[[gnu::visibility("default")]] ClipInfo read_clip_info(const std::string& clip);

}  // namespace vvr
