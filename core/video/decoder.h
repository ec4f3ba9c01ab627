#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/video/demuxer.h"
#include "core/video/packet_scan.h"

namespace vvr::video {

/// Decodes the packets of one demuxer, in order. Must not outlive it.
class Decoder {
  public:
    /// More than one thread decodes an intact stream to the same frames as one thread does. What libav makes of a
    /// damaged one depends on which thread was the faster, so such a decoder stops at the first damage instead.
    ///
    /// \param threads 0 = one for each core, or one alone for small pictures
    /// \throws Error not_video when there is no decoder for the stream
    Decoder(Demuxer& demuxer, const std::string& name, int threads);

    /// The next frame that decodes; nothing at the end, after very many failures in a row, or when it has stopped.
    AvFrame next();

    bool threaded() const { return threaded_; }  ///< whether it decodes on more than one thread

    /// Whether it met damage that only a decoder of one thread may pass.
    bool stopped() const { return stopped_; }

    /// From now on `next` gives only frames that the plan wants, and others that cost nothing to leave out.
    /// \param uses of the packets from the next one on
    void follow(std::vector<PacketUse> uses) { uses_ = std::move(uses); }

    /// The frame of one key packet by itself; nothing when it doesn't decode alone. Not to be mixed with `next`.
    AvFrame decode_alone(const AVPacket& packet);

    /// Packets that failed to be read or decoded, or gave a damaged frame.
    std::int64_t damaged() const;

  private:
    bool read_packet();

    Demuxer* demuxer_;
    av::Ptr<AVCodecContext> codec_;
    av::Ptr<AVPacket> packet_ = av::make_packet();
    std::int64_t bad_packets_ = 0;
    std::int64_t bad_frames_ = 0;
    std::int64_t errors_at_start_ = 0;  ///< in the log
    std::vector<PacketUse> uses_;       ///< empty = all packets are decoded
    std::size_t packets_ = 0;           ///< read so far, for the place in `uses_`
    bool threaded_ = false;
    bool stopped_ = false;
};

}  // namespace vvr::video
