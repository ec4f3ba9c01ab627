#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/video/frame_span.h"
#include "core/video/input.h"

namespace vvr::video {

/// A stretch of a clip that can be copied: packets of its video stream, from a key packet on. Times are seconds from
/// the clip's first frame.
struct PacketRange {
    std::int64_t first = 0;        ///< the key packet's number among the packets of the video stream
    std::int64_t last = 0;         ///< number of the last packet that is needed
    std::int64_t first_stamp = 0;  ///< the key frame's, in ticks of the stream; earlier ones are not shown
    std::int64_t last_stamp = 0;   ///< of the frame that is shown last
    double begin = 0;              ///< the key frame's time
    double end = 0;                ///< time of the frame that is shown last
    double wanted = 0;             ///< time of the first frame that was asked for; not before `begin`
    std::int64_t frames = 0;       ///< that were asked for; 0 = the span has none, and nothing else is known
    std::optional<double> over{};  ///< where it has none: time of the clip's last frame, if that comes before the span
    std::int64_t damaged = 0;      ///< packets of it that the container marks as damaged
    bool ends_early = false;       ///< the clip ends before the span does
};

/// The packets that it takes to show a span of a clip, without decoding more than its first frame. Reads the file only
/// as far as the span.
/// \param rate frames per second of what carries no times
/// \throws Error not_video where the clip's packets don't say when they are shown, or no key frame comes before the
/// span
PacketRange find_packets(const Input& input, double rate, const FrameSpan& span);

/// How long a clip is shown, by the packets of all of it, in seconds from its first frame that decodes. Where its clock
/// goes back, time goes on, as it does where the clip is decoded.
/// \throws Error not_video where no frame decodes
double length_of(const Input& input, double rate);

/// Says that a span has no frame.
/// \param last time of the clip's last frame, seconds; none = unknown
[[noreturn]] void throw_empty(const std::string& name, const FrameSpan& span, std::optional<double> last);

}  // namespace vvr::video
