#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <string>
#include <vector>

#include "core/media/decoder.h"

namespace vvr::media {

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

    std::int64_t damaged() const override { return bad_packets_ + unread_; }
    bool fell_back() const override;

    /// Whether another packet can be sent before `receive` is called.
    bool has_room() const { return decoding_.size() < slots_.size(); }

    /// Starts to decode a packet of the same stream.
    /// \pre has_room()
    void send(const AVPacket& packet);

    /// The frame of the packet that was sent first. Null if that is damaged or needs other packets.
    /// \pre a packet has been sent for each call
    /// \throws Error out_of_memory
    AvFrame receive();

  private:
    struct Slot {
        Slot(Demuxer& demuxer, const std::string& name, const HwaccelRow& hwaccel)
            : decoder(demuxer, name, 1, {}, hwaccel) {}

        Decoder decoder;
        std::size_t version = 0;  ///< of the extradata that it has
    };
    struct Sent {
        std::future<AvFrame> frame;
        std::int64_t unread = 0;  ///< damaged packets of the demuxer until then
    };

    Demuxer* demuxer_;
    std::function<bool(const AVPacket&)> decodes_;
    std::deque<Slot> slots_;
    std::deque<Sent> decoding_;  ///< after `slots_`, so that it waits for them before they go
    std::size_t sent_ = 0;
    std::vector<std::uint8_t> extradata_;  ///< the last that came with a packet: containers send it once, to one slot
    std::size_t version_ = 0;              ///< of `extradata_`; 0 = that of the stream
    bool has_ended_ = false;
    std::int64_t bad_packets_ = 0;
    std::int64_t unread_ = 0;  ///< damaged packets of the demuxer until the last received frame
    av::Ptr<AVPacket> packet_ = av::make_packet();
};

}  // namespace vvr::media
