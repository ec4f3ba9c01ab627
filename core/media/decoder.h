#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/media/demuxer.h"
#include "core/media/frame_choice.h"
#include "core/media/hwaccel.h"
#include "core/media/input.h"

namespace vvr::media {

/// Decodes the packets of one demuxer, in order.
class FrameDecoder {
  public:
    FrameDecoder() = default;
    virtual ~FrameDecoder() = default;
    FrameDecoder(const FrameDecoder&) = delete;
    FrameDecoder& operator=(const FrameDecoder&) = delete;

    /// The next frame that decodes. Null at the end, and where the decoder gives up: after too many consecutive
    /// failures, or once stopped.
    virtual AvFrame next() = 0;

    /// Whether a decoder with several threads has stopped at damage.
    virtual bool stopped() const { return false; }

    /// Packets that could not be read or decoded, or that gave a damaged frame.
    virtual std::int64_t damaged() const = 0;

    /// Whether the processor has decoded frames that hardware was to decode.
    virtual bool fell_back() const = 0;
};

/// Whether a frame was decoded without others, so that earlier damage doesn't show in it.
bool is_key_frame(const AVFrame& frame);

/// The number of threads for decoding.
/// \param asked 0 = one per core, or a single one for small pictures
/// \param pixels of a picture; each thread keeps pictures of its own
int decoder_threads(int asked, std::int64_t pixels);

/// Decodes all frames. The demuxer must outlive the decoder.
class Decoder final : public FrameDecoder {
  public:
    /// For an intact stream, the frames don't depend on the number of threads. For a damaged stream, libav's
    /// multithreaded output depends on a race, so a decoder with several threads stops at the first damage.
    ///
    /// \param threads 0 = one per core, or a single one for small pictures
    /// \param decodes the packets that are decoded; empty = all
    /// \param hwaccel what decodes; if it can't decode this video, the processor does
    /// \throws Error not_video if FFmpeg has no decoder for the stream, hwaccel_unavailable
    Decoder(Demuxer& demuxer, const std::string& name, int threads, std::function<bool(const AVPacket&)> decodes = {},
            const HwaccelRow& hwaccel = hwaccels().front());

    AvFrame next() override;
    bool stopped() const override { return stopped_; }
    std::int64_t damaged() const override;
    bool fell_back() const override { return fell_back_; }

    /// Decodes one key packet on its own. Null if it is damaged or needs other packets. Don't mix with calls of `next`.
    /// \throws Error out_of_memory
    AvFrame decode_alone(const AVPacket& packet);

  private:
    bool read();
    AvFrame to_memory(AvFrame frame);

    Demuxer* demuxer_;
    std::function<bool(const AVPacket&)> decodes_;
    av::Ptr<AVCodecContext> codec_;
    av::Ptr<AVPacket> packet_ = av::make_packet();
    std::int64_t bad_packets_ = 0;
    std::int64_t bad_frames_ = 0;
    std::int64_t errors_at_start_ = 0;  ///< errors in the log when the decoder was opened
    bool wants_hardware_ = false;
    bool fell_back_ = false;
    bool threaded_ = false;
    bool stopped_ = false;
};

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
