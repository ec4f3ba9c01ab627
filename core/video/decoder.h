#pragma once

#include <cstdint>

#include "core/video/demuxer.h"

namespace vvr {

/// Decodes the packets of one demuxer, in order. Must not outlive it.
class Decoder {
  public:
    /// More than one thread decodes an intact stream to the same frames as one thread does. What libav makes of a
    /// damaged one depends on which thread was the faster, so such a decoder stops at the first damage instead.
    ///
    /// \param threads 0 = one for each core
    /// \throws Error not_video when there is no decoder for the stream
    Decoder(Demuxer& demuxer, const std::string& name, int threads);

    /// The next frame that decodes; nothing at the end, after very many failures in a row, or when it has stopped.
    AvFrame next();

    /// Whether it met damage that only a decoder of one thread may pass.
    bool stopped() const { return stopped_; }

    /// The frame of one key packet by itself; nothing when it doesn't decode alone. Not to be mixed with `next`.
    AvFrame decode_alone(const AVPacket& packet);

    /// Packets that failed to be read or decoded, or gave a damaged frame.
    std::int64_t damaged() const;

  private:
    Demuxer* demuxer_;
    av::Ptr<AVCodecContext> codec_;
    av::Ptr<AVPacket> packet_ = av::make_packet();
    std::int64_t bad_packets_ = 0;
    std::int64_t bad_frames_ = 0;
    std::int64_t errors_at_start_ = 0;  ///< in the log
    bool threaded_ = false;
    bool stopped_ = false;
};

}  // namespace vvr
