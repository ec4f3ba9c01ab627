#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/av_muxer.h"
#include "core/media/frame_span.h"
#include "core/media/input.h"

namespace vvr::media {

/// A packet range of a clip's video stream that can be copied. It begins with a key packet. Times are seconds from the
/// clip's first frame.
struct PacketRange {
    std::int64_t first = 0;        ///< index of the key packet in the video stream
    std::int64_t last = 0;         ///< index of the last packet that is needed
    std::int64_t first_stamp = 0;  ///< of the key frame, in the stream's time base; earlier frames are not shown
    std::int64_t last_stamp = 0;   ///< presentation timestamp of the last frame
    double begin = 0;              ///< time of the key frame
    double end = 0;                ///< time of the last frame
    double until = 0;              ///< when the last frame is over
    double wanted = 0;             ///< time of the first requested frame; at least `begin`
    std::optional<double> over{};  ///< time of the clip's last frame if the whole clip comes before the span
    bool ends_early = false;       ///< the clip ends before the span does

    /// A frame of the range; its number is that of a `FileSource`.
    struct Frame {
        std::size_t packet = 0;  ///< index in the video stream
        std::int64_t number = 0;
        double time = 0;
        bool damaged = false;  ///< as the container marks it
    };
    std::vector<Frame> frames{};  ///< in the order in which they are shown; empty = none, and only `over` is set
};

/// Finds the packets that are needed to show a span of a clip. Decodes only the clip's first frame, and reads the file
/// only up to the end of the span.
/// \param rate frames per second of inputs without timestamps
/// \throws Error not_video if packets have no presentation timestamps, or if no key frame comes before the span
PacketRange find_packets(const Input& input, double rate, const FrameSpan& span);

/// A clip's duration from its first frame that decodes, in seconds. Reads all packets, and handles clock jumps as
/// StampClock does.
/// \throws Error not_video if no frame decodes
double length_of(const Input& input, double rate);

/// Metadata of a container: libav's keys and their values.
using Tags = std::vector<std::pair<std::string, std::string>>;

/// A packet range of one of the files that are joined.
struct CopyPart {
    Input input;
    PacketRange piece;
    double begin = 0;  ///< time of the file's first frame in the recording, seconds
};

/// What was copied.
struct CopyResult {
    std::int64_t packets = 0;           ///< packets of the video stream
    std::vector<std::string> left_out;  ///< omitted streams: cover pictures, and other than video, audio and subtitles
};

/// Copies packet ranges into a container without decoding, with all their streams. Timestamps start at 0 with the first
/// key frame, and gaps between files are kept. The output is deterministic.
/// \param parts in order of time; at least one
/// \param rate frames per second of inputs without timestamps
/// \param check_stop called for each packet; throws to stop
/// \throws Error usage if the container can't hold a stream, or if the streams of two files differ; io if reading or
///         writing fails
CopyResult copy_pieces(std::span<const CopyPart> parts, double rate, const std::filesystem::path& path,
                       const Tags& tags, const WriteAt& write_at, const std::function<void()>& check_stop);

}  // namespace vvr::media
