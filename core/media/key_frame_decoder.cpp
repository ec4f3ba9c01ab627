#include "core/media/key_frame_decoder.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace vvr::media {

KeyFrameDecoder::KeyFrameDecoder(Demuxer& demuxer, const std::string& name, int threads,
                                 std::function<bool(const AVPacket&)> decodes, const HwaccelRow& hwaccel)
    : demuxer_(&demuxer), decodes_(std::move(decodes)) {
    const AVCodecParameters& stream = *demuxer.stream().codecpar;
    const bool in_software = hwaccel.device == AV_HWDEVICE_TYPE_NONE;
    const int count = in_software ? decoder_threads(threads, std::int64_t{stream.width} * stream.height) : 1;
    for (int i = 0; i < count; ++i) slots_.emplace_back(demuxer, name, hwaccel);
}

void KeyFrameDecoder::send(const AVPacket& packet) {
    av::Ptr<AVPacket> copy = av::copy_of(packet);
    std::size_t bytes = 0;
    const std::uint8_t* const sent = av_packet_get_side_data(&packet, AV_PKT_DATA_NEW_EXTRADATA, &bytes);
    if (sent != nullptr) {
        extradata_.assign(sent, sent + bytes);
        ++version_;
    }
    Slot& slot = slots_[sent_++ % slots_.size()];  // idle, as `receive` has waited for its last frame
    if (sent == nullptr && slot.version != version_) {
        std::uint8_t* const room = av_packet_new_side_data(copy.get(), AV_PKT_DATA_NEW_EXTRADATA, extradata_.size());
        if (room == nullptr) av::throw_out_of_memory();
        std::ranges::copy(extradata_, room);
    }
    slot.version = version_;
    const std::shared_ptr<const AVPacket> kept = std::move(copy);
    // On another thread if the system has one.
    const auto how = slots_.size() > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
    auto frame = std::async(how, [&decoder = slot.decoder, kept] { return decoder.decode_alone(*kept); });
    decoding_.push_back({std::move(frame), demuxer_->damaged()});
}

AvFrame KeyFrameDecoder::receive() {
    Sent first = std::move(decoding_.front());
    decoding_.pop_front();
    unread_ = first.unread;
    return first.frame.get();
}

AvFrame KeyFrameDecoder::next() {
    for (;;) {
        while (!has_ended_ && has_room()) {
            has_ended_ = !demuxer_->read(*packet_);
            if (!has_ended_ && (!decodes_ || decodes_(*packet_))) send(*packet_);
        }
        if (decoding_.empty()) {
            unread_ = demuxer_->damaged();
            return nullptr;
        }
        if (AvFrame frame = receive()) return frame;
        ++bad_packets_;
    }
}

bool KeyFrameDecoder::fell_back() const {
    return std::ranges::any_of(slots_, [](const Slot& slot) { return slot.decoder.fell_back(); });
}

}  // namespace vvr::media
