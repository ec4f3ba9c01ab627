#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <string>
#include <vector>

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

    std::int64_t damaged() const override { return bad_packets_ + unread_; }
    bool fell_back() const override;

    /// Whether another packet can be sent before `receive` is called.
    bool has_room() const { return decoding_.size() < threads_.size(); }

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
    struct Thread {
        Thread(Demuxer& demuxer, const std::string& name, const HwaccelRow& hwaccel)
            : decoder(demuxer, name, 1, {}, hwaccel) {}

        Decoder decoder;
        std::size_t headers = 0;  ///< how many of the new headers it has
    };
    struct Sent {
        std::future<AvFrame> frame;
        std::int64_t unread = 0;  ///< damaged packets of the demuxer until then
    };

    std::deque<Thread> threads_;
    std::deque<Sent> decoding_;
    std::size_t sent_ = 0;
    std::size_t headers_ = 0;           ///< number of new headers in the stream so far
    std::vector<std::uint8_t> header_;  ///< the last of them; a container sends it once
    bool has_ended_ = false;
    std::int64_t bad_packets_ = 0;
    std::int64_t unread_ = 0;  ///< damaged packets of the demuxer until the last received frame
    av::Ptr<AVPacket> packet_ = av::make_packet();
};

}  // namespace vvr::video
