#pragma once

#include <cstdint>

#include "core/video/demuxer.h"

namespace vvr {

/// Decodes the packets of one demuxer, in order. Must not outlive it.
class Decoder {
  public:
    /// \param threads 0 = one for each core
    /// \throws Error not_video when there is no decoder for the stream
    Decoder(Demuxer& demuxer, const std::string& name, int threads);

    /// The next frame that decodes; nothing at the end, or after very many failures in a row.
    AvFrame next();

    /// The frame of one key packet by itself; nothing when it doesn't decode alone. Not to be mixed with `next`.
    AvFrame decode_alone(const AVPacket& packet);

    /// Packets that failed to be read or decoded, and frames that came out damaged.
    std::int64_t damaged() const { return damaged_ + demuxer_->damaged(); }

  private:
    Demuxer* demuxer_;
    av::Ptr<AVCodecContext> codec_;
    av::Ptr<AVPacket> packet_ = av::make_packet();
    std::int64_t damaged_ = 0;
};

}  // namespace vvr
