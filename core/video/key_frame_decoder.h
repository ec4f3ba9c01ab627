#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <string>

#include "core/video/decoder.h"

namespace vvr::video {

/// Decodes key frames, each on its own, several at a time. The demuxer must outlive it.
class KeyFrameDecoder final : public FrameDecoder {
  public:
    /// \param threads 0 = one per core, or a single one for small pictures
    /// \param decodes the packets that `next` decodes; each must be a key frame's
    /// \param hwaccel what decodes; if it can't decode this video, the processor does
    /// \throws Error as Decoder
    KeyFrameDecoder(Demuxer& demuxer, const std::string& name, int threads,
                    std::function<bool(const AVPacket&)> decodes = {}, const HwaccelRow& hwaccel = hwaccels().front());

    /// Reads packets ahead from the demuxer, and skips those that are damaged or need other packets.
    AvFrame next() override;

    std::int64_t damaged() const override { return bad_packets_ + demuxer_->damaged(); }
    bool fell_back() const override;

    /// Whether another packet can be sent before `receive` is called.
    bool has_room() const { return decoding_.size() < decoders_.size(); }

    /// Starts to decode a packet of the same stream.
    /// \pre has_room()
    void send(const AVPacket& packet);

    /// The frame of the packet that was sent first. Null if that is damaged or needs other packets.
    /// \pre a packet has been sent for each call
    /// \throws Error out_of_memory
    AvFrame receive();

  private:
    Demuxer* demuxer_;
    std::function<bool(const AVPacket&)> decodes_;
    std::deque<Decoder> decoders_;  ///< one per thread
    std::deque<std::future<AvFrame>> decoding_;
    std::size_t sent_ = 0;
    std::int64_t bad_packets_ = 0;
    av::Ptr<AVPacket> packet_ = av::make_packet();
};

}  // namespace vvr::video
