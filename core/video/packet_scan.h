#pragma once

#include <cstdint>
#include <vector>

#include "core/video/demuxer.h"

// What the packets of a clip tell without being decoded. Reading a file through costs little beside decoding it, and
// needs neither an index nor a container that seeks well.
namespace vvr::video {

/// Where decoding has to begin so that the first frame at or after a time comes out whole.
struct SeekPoint {
    std::int64_t packets = 0;  ///< packets to pass over undecoded; 0 = decode from the first
    std::int64_t frames = 0;   ///< frames before the time; only where `packets` isn't 0
};

/// \param demuxer at its first packet
/// \param time on the container's clock, seconds
SeekPoint find_seek_point(Demuxer& demuxer, double time);

/// Key packets spread over a clip.
struct KeyPackets {
    std::vector<av::Ptr<AVPacket>> kept;
    std::int64_t seen = 0;
};

/// At most `count` of the key packets.
///
/// \param demuxer at its first packet
KeyPackets find_key_packets(Demuxer& demuxer, int count);

/// A packet in the order of decoding.
struct StampedPacket {
    std::int64_t stamp;
    bool key;
};

/// All packets of a clip, and its frames in the order in which they are shown.
struct ClipPackets {
    std::vector<StampedPacket> packets;
    std::vector<std::int64_t> stamps;  ///< the frames' time stamps
    std::vector<double> times;         ///< the frames' times in seconds from the first frame
};

/// None where the packets' times don't tell which frames there are.
///
/// \param demuxer at its first packet
ClipPackets scan_packets(Demuxer& demuxer);

/// What a decoder has to make of a packet where only some frames of a clip are wanted, each as it would come out if all
/// were decoded.
enum class PacketUse : std::uint8_t {
    none,       ///< nothing that is wanted depends on it
    reference,  ///< its frame isn't wanted, but another may depend on it
    frame,      ///< its frame is wanted
};

/// A packet from which on decoding needs nothing that comes before it.
struct RandomAccessPoint {
    std::size_t packet = 0;
    std::int64_t stamp = 0;  ///< no wanted frame of the packets before it is as late
};

/// Frames of a clip that are wanted, and what it takes to decode them.
struct DecodingPlan {
    std::vector<PacketUse> uses;            ///< of every packet
    std::vector<std::int64_t> stamps;       ///< the wanted frames' time stamps, in order
    std::vector<RandomAccessPoint> starts;  ///< after the first packet, in order
};

/// The time stamps of the frames that a TimeSampler of `count` items would keep of all frames.
std::vector<std::int64_t> sampled_stamps(const ClipPackets& clip, int count);

/// How to decode some frames, each as it would come out if all were decoded.
/// \param stamps of the wanted frames, in order
DecodingPlan plan_decoding(const ClipPackets& clip, std::vector<std::int64_t> stamps);

/// Cuts a plan into at most `parts` of which each can be decoded by itself, with about as much to decode in each. Their
/// frames one after another are the plan's.
std::vector<DecodingPlan> cut_plan(const DecodingPlan& plan, int parts);

}  // namespace vvr::video
