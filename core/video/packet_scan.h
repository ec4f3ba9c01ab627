#pragma once

#include <cstdint>
#include <vector>

#include "core/video/demuxer.h"

// What the packets of a clip tell without being decoded. Reading a file through costs little beside decoding it, and
// needs neither an index nor a container that seeks well.
namespace vvr {

/// Where decoding has to begin so that the first frame at or after a time comes out whole.
struct Start {
    std::int64_t packets = 0;  ///< packets to pass over undecoded; 0 = decode from the first
    std::int64_t frames = 0;   ///< frames before the time; only where `packets` isn't 0
};

/// \param demuxer at its first packet
/// \param time on the container's clock, seconds
Start find_start(Demuxer& demuxer, double time);

/// Key packets spread over a clip.
struct KeyPackets {
    std::vector<av::Ptr<AVPacket>> kept;
    std::int64_t seen = 0;
};

/// At most `count` of the key packets.
///
/// \param demuxer at its first packet
KeyPackets find_key_packets(Demuxer& demuxer, int count);

}  // namespace vvr
