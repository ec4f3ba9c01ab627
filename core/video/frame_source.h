#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/video/frame.h"

namespace vvr {

/// What a container says of its video before a frame is decoded. Headers lie: counts are estimates.
struct VideoInfo {
    std::string name;           ///< as the user gave it
    std::string container;      ///< short name of the format, e.g. "avi"
    std::string codec;          ///< short name of the codec, e.g. "h264"
    Size size;                  ///< of the picture as it is to be seen: rotated, square pixels
    double rate = 0;            ///< frames a second, the container's average; 0 = unknown
    double duration = 0;        ///< seconds; 0 = unknown
    std::int64_t frames = 0;    ///< estimate of the number of frames; 0 = unknown
};

struct SourceOptions {
    Size field_size{0, 0};           ///< {0, 0}: long side at most 384, aspect kept; {-1, -1}: the video's own size
    bool colour = false;             ///< fill Frame::colour as well
    int threads = 0;                 ///< decoder threads; 0 = one for each core
    double start = 0;                ///< seconds; frames before it are passed over
    std::optional<double> end;       ///< seconds; no frame at or after it
};

/// A frame as it left the decoder: a reference to its buffers, not yet scaled. Cheap to move between threads.
class DecodedFrame;

/// Frames of a video file, an image sequence or a piped stream, each once and in order.
class FrameSource {
  public:
    virtual ~FrameSource() = default;

    virtual const VideoInfo& info() const = 0;

    /// The size that every `Frame` of this source has.
    virtual Size field_size() const = 0;

    /// The next frame that decodes; nothing after the last one. Damaged packets are counted and passed over.
    virtual std::unique_ptr<DecodedFrame> next() = 0;

    /// Packets, or pictures of a sequence, that could not be decoded so far.
    virtual std::int64_t damaged() const = 0;

    /// Starts again at the first frame.
    virtual void rewind() = 0;
};

}  // namespace vvr
