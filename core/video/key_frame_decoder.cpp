#include "core/video/key_frame_decoder.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/base/error.h"

namespace vvr::video {

KeyFrameDecoder::KeyFrameDecoder(Demuxer& demuxer, const std::string& name, int threads,
                                 std::function<bool(const AVPacket&)> decodes, const HwaccelRow& hwaccel)
    : demuxer_(&demuxer), decodes_(std::move(decodes)) {
    const AVCodecParameters& stream = *demuxer.stream().codecpar;
    const bool in_software = hwaccel.device == AV_HWDEVICE_TYPE_NONE;
    const int count = in_software ? decoder_threads(threads, std::int64_t{stream.width} * stream.height) : 1;
    for (int i = 0; i < count; ++i) decoders_.emplace_back(demuxer, name, 1, decodes_, hwaccel);
}

void KeyFrameDecoder::send(const AVPacket& packet) {
    const std::shared_ptr<const AVPacket> kept(av_packet_clone(&packet), av::Free());
    if (!kept) throw Error(ErrorCode::out_of_memory, "out of memory while reading the video; give vvr more memory");
    Decoder& decoder = decoders_[sent_++ % decoders_.size()];  // idle, as `receive` has waited for its last frame
    // Another thread if the system has one.
    const auto how = decoders_.size() > 1 ? std::launch::async | std::launch::deferred : std::launch::deferred;
    decoding_.push_back(std::async(how, [&decoder, kept] { return decoder.decode_alone(*kept); }));
}

AvFrame KeyFrameDecoder::receive() {
    std::future<AvFrame> first = std::move(decoding_.front());
    decoding_.pop_front();
    return first.get();
}

AvFrame KeyFrameDecoder::next() {
    for (;;) {
        while (has_room() && demuxer_->read(*packet_)) {
            if (!decodes_ || decodes_(*packet_)) send(*packet_);
        }
        if (decoding_.empty()) return nullptr;
        if (AvFrame frame = receive()) return frame;
        ++bad_packets_;
    }
}

bool KeyFrameDecoder::fell_back() const {
    return std::ranges::any_of(decoders_, [](const Decoder& decoder) { return decoder.fell_back(); });
}

}  // namespace vvr::video
