#include "core/video/decoder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr::video {
namespace {

constexpr double clock_was_set = 1;  // seconds

// Consecutive failures after which reading ends: about a quarter of an hour of frames.
constexpr int max_failures = 20'000;

// Each decoder thread holds its own frames, so huge pictures get fewer threads. For small pictures, the overhead of
// threads exceeds the gain.
int thread_count(int asked, std::int64_t pixels) {
    constexpr std::int64_t pixels_in_flight = 256'000'000;
    constexpr std::int64_t small = 200'000;
    if (asked <= 0 && pixels < small) return 1;
    const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const std::int64_t affordable = std::max<std::int64_t>(1, pixels_in_flight / std::max<std::int64_t>(1, pixels));
    return static_cast<int>(std::min<std::int64_t>(std::clamp(asked > 0 ? asked : cores, 1, 64), affordable));
}

// Codecs whose decoders reliably stop at the first damage on request, so that frames never depend on a race. MPEG-4 is
// not among them, because its decoder fails an assertion with threads. HEVC and VP8 are not, because their decoders
// often miss damage.
bool stops_cleanly(AVCodecID codec) {
    constexpr std::array known{AV_CODEC_ID_H264, AV_CODEC_ID_VP9,    AV_CODEC_ID_AV1,       AV_CODEC_ID_MJPEG,
                               AV_CODEC_ID_FFV1, AV_CODEC_ID_PRORES, AV_CODEC_ID_MPEG2VIDEO};
    return std::find(known.begin(), known.end(), codec) != known.end();
}

/// Whether the codec has frames that refer to other frames.
bool has_inter_frames(const Demuxer& demuxer) {
    const AVCodecDescriptor* const codec = avcodec_descriptor_get(demuxer.stream().codecpar->codec_id);
    return codec == nullptr || (codec->props & AV_CODEC_PROP_INTRA_ONLY) == 0;
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
    codec_->thread_count = thread_count(threads, std::int64_t{parameters.width} * parameters.height);
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
        throw Error(
            ErrorCode::not_video,
            fmt::format("cannot decode '{}': the {} decoder failed to start: {}; convert the video to H.264 first",
                        name, codec->name, demuxer.log().text(code)));
    }
}

/// Frames leave the hardware at once, as it has room for only a few.
AvFrame Decoder::to_memory(AvFrame frame) {
    fell_back_ = fell_back_ || (wants_hardware_ && frame->hw_frames_ctx == nullptr);
    return downloaded(std::move(frame));
}

/// Reads the next packet that is decoded.
bool Decoder::read() {
    while (demuxer_->read(*packet_)) {
        if (!decodes_ || decodes_(*packet_)) return true;
    }
    return false;
}

AvFrame Decoder::next_alone() {
    while (read()) {
        if (auto frame = decode_alone(*packet_)) return frame;
        ++bad_packets_;
    }
    return nullptr;
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

double StampClock::operator()(std::optional<double> stamp) {
    if (!origin_ && stamp) origin_ = *stamp - next();
    double time = stamp ? *stamp - *origin_ : next();
    if (last_ && time < *last_ - clock_was_set) {
        time = next();
        origin_ = *stamp - time;
    }
    if (last_ && time < *last_) time = *last_;
    last_ = time;
    return time;
}

double StampClock::next() const {
    return last_ ? *last_ + duration_ : 0;
}

VideoReader::VideoReader(Input input, double rate, int threads, const FrameChoiceRow& choice, const HwaccelRow& hwaccel)
    : input_(std::move(input)), rate_(rate), threads_(threads), choice_(&choice), hwaccel_(&hwaccel) {
    open({});
}

void VideoReader::open(const SeekPoint& start) {
    close();
    demuxer_ = std::make_unique<Demuxer>(input_, Demuxer::Kind::video, rate_);
    const AVCodecParameters& stream = *demuxer_->stream().codecpar;
    decoder_ = std::make_unique<Decoder>(
        *demuxer_, input_.name, choice_->alone ? 1 : threads_,
        [this, &stream](const AVPacket& packet) { return choice_->decodes(packet, stream); }, *hwaccel_);
    forgotten_ = 0;
    pass_frames_ = 0;
    pass_until_.reset();
    const double duration = demuxer_->frame_duration();
    clock_ = origin_ ? StampClock(duration, *origin_) : StampClock(duration);
    const auto packet = av::make_packet();
    for (std::int64_t i = 0; i < start.packets; ++i) {
        if (!demuxer_->read(*packet)) return;
    }
}

void VideoReader::close() {
    if (decoder_) damaged_ = decoder_->damaged();
    fell_back_ = fell_back();
    decoder_.reset();
    demuxer_.reset();
}

void VideoReader::choose(const FrameChoiceRow& choice) {
    choice_ = &choice;
    rewind();
}

void VideoReader::rewind(const SeekPoint& start) {
    start_ = start;
    given_ = 0;
    open(start);
}

SeekPoint VideoReader::find(double time) const {
    Demuxer demuxer(input_, Demuxer::Kind::video, rate_);
    const double end = origin() + time;
    const auto packet = av::make_packet();
    std::int64_t packets = 0;
    std::int64_t frames = 0;
    // Decoding begins one key frame early. Then leading frames, which follow a key frame but are shown before it, and
    // streams with gradual refresh are intact.
    std::int64_t last_key = 0;
    std::int64_t key_before = 0;
    std::int64_t keys = 0;
    double last_dts = -std::numeric_limits<double>::infinity();
    while (demuxer.read(*packet)) {
        const auto pts = demuxer.seconds(packet->pts != AV_NOPTS_VALUE ? packet->pts : packet->dts);
        const auto dts = demuxer.seconds(packet->dts);
        // Without ascending timestamps, the frame count would be a guess.
        if (!pts || !dts || *dts < last_dts) return {};
        if (*dts >= end) break;
        last_dts = *dts;
        if (*pts < end && choice_->decodes(*packet, *demuxer.stream().codecpar)) ++frames;
        keys += packet->flags & AV_PKT_FLAG_KEY ? 1 : 0;
        if (packet->flags & AV_PKT_FLAG_KEY && *pts <= end) {
            key_before = last_key;
            last_key = packets;
        }
        ++packets;
    }
    // Some files mark every packet as a key frame, which is implausible for these codecs.
    if (keys == packets && has_inter_frames(demuxer)) return {};
    return {key_before, frames};
}

VideoReader::Timed VideoReader::next() {
    while (decoder_) {
        auto image = choice_->alone ? decoder_->next_alone() : decoder_->next();
        if (!image && !decoder_->stopped()) return {};
        if (!image) {
            fall_back_to_one_thread();
            continue;
        }
        const double time = clock_(demuxer_->seconds(image->best_effort_timestamp));
        if (!origin_) origin_ = clock_.origin();
        if (pass_frames_ > 0 || (pass_until_ && time <= *pass_until_)) {
            pass_frames_ = std::max<std::int64_t>(0, pass_frames_ - 1);
            forget_damage();
            continue;
        }
        ++given_;
        last_ = time;
        return {std::move(image), time};
    }
    return {};
}

/// Decodes again from shortly before the damage, and skips the frames that were already returned.
void VideoReader::fall_back_to_one_thread() {
    threads_ = 1;
    const auto near = given_ > 0 ? find(last_) : SeekPoint{};
    if (near.packets > start_.packets) {
        open(near);
        pass_until_ = last_;
    } else {
        open(start_);
        pass_frames_ = given_;
    }
}

}  // namespace vvr::video
