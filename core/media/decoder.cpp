#include "core/media/decoder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr::media {

namespace {

// Consecutive failures after which reading ends: about a quarter of an hour of frames.
constexpr int max_failures = 20'000;

// Codecs whose decoders reliably stop at the first damage on request, so that frames never depend on a race. MPEG-4 is
// not among them, because its decoder fails an assertion with threads. HEVC and VP8 are not, because their decoders
// often miss damage.
bool stops_cleanly(AVCodecID codec) {
    constexpr std::array known{AV_CODEC_ID_H264, AV_CODEC_ID_VP9,    AV_CODEC_ID_AV1,       AV_CODEC_ID_MJPEG,
                               AV_CODEC_ID_FFV1, AV_CODEC_ID_PRORES, AV_CODEC_ID_MPEG2VIDEO};
    return std::find(known.begin(), known.end(), codec) != known.end();
}

/// Distinguishes damage from a lack of memory, which some decoders report as -1.
/// \param code libavcodec's
/// \throws Error out_of_memory
void require_memory(int code, const av::Log& log) {
    constexpr int unspecified = -1;
    constexpr std::int64_t needed = 32'000'000;  // bytes: more than a decoder allocates beside its frames
    const bool enough = code != AVERROR(ENOMEM) && (code != unspecified || is_memory_available(needed));
    if (enough && !log.out_of_memory()) return;
    throw Error(ErrorCode::out_of_memory, "out of memory while decoding the video; use fewer threads", {"threads"});
}

bool is_damaged(const AVFrame& frame) {
    return frame.flags & AV_FRAME_FLAG_CORRUPT || frame.decode_error_flags != 0;
}

}  // namespace

bool is_key_frame(const AVFrame& frame) {
    return frame.key_frame != 0;
}

// Each decoder thread holds its own frames, so huge pictures get fewer threads. For small pictures, the overhead of
// threads exceeds the gain.
int decoder_threads(int asked, std::int64_t pixels) {
    constexpr std::int64_t pixels_in_flight = 256'000'000;
    constexpr std::int64_t small = 200'000;
    if (asked <= 0 && pixels < small) return 1;
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const std::int64_t affordable = std::max<std::int64_t>(1, pixels_in_flight / std::max<std::int64_t>(1, pixels));
    return static_cast<int>(std::min<std::int64_t>(std::clamp(asked > 0 ? asked : cores, 1, 64), affordable));
}

Decoder::Decoder(Demuxer& demuxer, const std::string& name, int threads, std::function<bool(const AVPacket&)> decodes,
                 const HwaccelRow& hwaccel)
    : demuxer_(&demuxer), decodes_(std::move(decodes)), wants_hardware_(hwaccel.device != AV_HWDEVICE_TYPE_NONE) {
    const auto& parameters = *demuxer.stream().codecpar;
    const AVCodec* codec = avcodec_find_decoder(parameters.codec_id);
    if (!codec) {
        throw Error(
            ErrorCode::codec_unsupported,
            fmt::format("cannot decode '{}': this FFmpeg has no decoder for {}; convert the video to H.264 first", name,
                        avcodec_get_name(parameters.codec_id)));
    }
    codec_.reset(avcodec_alloc_context3(codec));
    if (!codec_)
        throw Error(ErrorCode::out_of_memory, "out of memory for a video decoder; use fewer threads", {"threads"});
    demuxer.log().attach(*codec_);
    int code = avcodec_parameters_to_context(codec_.get(), &parameters);
    codec_->pkt_timebase = demuxer.stream().time_base;
    codec_->max_pixels = av::max_pixels;
    codec_->thread_count = decoder_threads(threads, std::int64_t{parameters.width} * parameters.height);
    if (!stops_cleanly(parameters.codec_id)) codec_->thread_count = 1;
    if (wants_hardware_ && hardware_format(*codec, hwaccel.device) != AV_PIX_FMT_NONE)
        use_device(*codec_, open_device(hwaccel));
    threaded_ = codec_->thread_count > 1;
    if (threaded_) {
        codec_->err_recognition = AV_EF_EXPLODE;
    } else {
        av::Log::record_memory(*codec_);
    }
    errors_at_start_ = demuxer.log().errors();
    if (code >= 0) code = avcodec_open2(codec_.get(), codec, nullptr);
    if (code < 0) {
        require_memory(code, demuxer.log());
        if (code == AVERROR(EAGAIN)) {
            throw Error(
                ErrorCode::out_of_memory,
                fmt::format(
                    "cannot decode '{}': no thread could be started; use fewer threads, or give vvr more memory", name),
                {"threads"});
        }
        throw Error(
            ErrorCode::not_video,
            fmt::format("cannot decode '{}': the {} decoder failed to start: {}; convert the video to H.264 first",
                        name, codec->name, demuxer.log().text(code)));
    }
}

/// Frames leave the hardware at once, as it has room for only a few.
AvFrame Decoder::to_memory(AvFrame frame) {
    if (wants_hardware_ && frame->hw_frames_ctx == nullptr) fell_back_ = true;
    return downloaded(std::move(frame));
}

/// Reads the next packet that is decoded.
bool Decoder::read() {
    while (demuxer_->read(*packet_)) {
        if (!decodes_ || decodes_(*packet_)) return true;
    }
    return false;
}

AvFrame Decoder::next() {
    auto frame = av::make_frame();
    for (int failures = 0; failures < max_failures;) {
        auto errors = demuxer_->log().errors();
        bool bad_packet = false;
        int code = avcodec_receive_frame(codec_.get(), frame.get());
        if (code == AVERROR_EOF) return nullptr;
        const bool has_frame = code == 0;
        if (code == AVERROR(EAGAIN)) {
            const bool more = read();
            bad_packet = more && packet_->flags & AV_PKT_FLAG_CORRUPT;
            errors = demuxer_->log().errors();
            code = avcodec_send_packet(codec_.get(), more ? packet_.get() : nullptr);
        }
        require_memory(code, demuxer_->log());

        // Some decoders report damage only in the log. Threads may log early; stopping too early is harmless.
        const std::int64_t harmless = threaded_ ? errors_at_start_ : std::max(errors, demuxer_->log().excused());
        bad_packet = bad_packet || code < 0 || demuxer_->log().errors() > harmless;
        const bool bad_frame = has_frame && is_damaged(*frame);
        bad_packets_ += bad_packet;
        bad_frames_ += bad_frame;
        stopped_ = threaded_ && (bad_packet || bad_frame);
        if (stopped_) return nullptr;
        if (has_frame) return to_memory(std::move(frame));
        failures += code < 0;
    }
    return nullptr;
}

// A damaged packet is in one or both of the counts.
std::int64_t Decoder::damaged() const {
    return std::max(bad_packets_, bad_frames_) + demuxer_->damaged();
}

AvFrame Decoder::decode_alone(const AVPacket& packet) {
    // Some decoders report a failed allocation as damage. Real damage fails twice.
    for (int attempts = 0; attempts < 2; ++attempts) {
        auto frame = av::make_frame();
        avcodec_flush_buffers(codec_.get());
        const int sent = avcodec_send_packet(codec_.get(), &packet);
        require_memory(sent, demuxer_->log());
        require_memory(avcodec_send_packet(codec_.get(), nullptr), demuxer_->log());
        const int received = avcodec_receive_frame(codec_.get(), frame.get());
        require_memory(received, demuxer_->log());
        if (sent >= 0 && received >= 0 && !is_damaged(*frame)) return to_memory(std::move(frame));
    }
    return nullptr;
}

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
