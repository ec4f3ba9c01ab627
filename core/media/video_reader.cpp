#include "core/media/video_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/media/container.h"

namespace vvr::media {

namespace {

/// Whether the codec has frames that refer to other frames.
bool has_inter_frames(const Demuxer& demuxer) {
    const AVCodecDescriptor* const codec = avcodec_descriptor_get(demuxer.stream().codecpar->codec_id);
    return codec == nullptr || (codec->props & AV_CODEC_PROP_INTRA_ONLY) == 0;
}

}  // namespace

double StampClock::operator()(std::optional<double> stamp) {
    if (!origin_ && stamp) origin_ = *stamp - next();
    double time = stamp ? *stamp - *origin_ : next();
    if (last_ && time < *last_ - clock_was_set) {
        time = next();
        origin_ = *stamp - time;
    }
    time = std::max(time, last_.value_or(time));
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
    const auto decodes = [this, &stream](const AVPacket& packet) { return choice_->decodes(packet, stream); };
    if (choice_->alone) {
        decoder_ = std::make_unique<KeyFrameDecoder>(*demuxer_, input_.name, threads_, decodes, *hwaccel_);
    } else {
        decoder_ = std::make_unique<Decoder>(*demuxer_, input_.name, threads_, decodes, *hwaccel_);
    }
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
    if (demuxer_ && demuxer_->mended().frames > mended_.frames) mended_ = demuxer_->mended();
    decoder_.reset();
    demuxer_.reset();
}

MendedFrames VideoReader::mended() const {
    MendedFrames mended = mended_;
    if (demuxer_ && demuxer_->mended().frames > mended.frames) mended = demuxer_->mended();
    mended.from -= origin();
    for (condition::Interval& interval : mended.intervals) {
        interval.begin -= origin();
        interval.end -= origin();
    }
    return mended;
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

std::int64_t FrameNumbers::operator()(double time) {
    constexpr double shortest_hole = 5;  // seconds
    constexpr double unusual = 20;       // intervals
    const double apart = time - std::exchange(last_, time);
    if (number_ < 0) return ++number_;
    const double usual = std::max(1 / rate_, interval_.value_or(apart));
    if (rate_ > 0 && apart >= std::max(shortest_hole, unusual * usual) && apart <= longest_clip) {
        return number_ += std::llround(apart * rate_);
    }
    interval_ = apart;
    return ++number_;
}

SeekPoint VideoReader::find(double time, double rate) const {
    Demuxer demuxer(input_, Demuxer::Kind::video, rate_);
    const double end = origin() + time;
    const auto packet = av::make_packet();
    std::int64_t packets = 0;
    std::vector<double> shown;  // times of the frames before `end`
    // Decoding begins one key frame early. Then leading frames, which follow a key frame but are shown before it, and
    // streams with gradual refresh are intact.
    std::int64_t last_key = 0;
    std::int64_t key_before = 0;
    std::int64_t keys = 0;
    double last_dts = -std::numeric_limits<double>::infinity();
    while (demuxer.read(*packet)) {
        const auto pts = demuxer.seconds(stamp_of(*packet));
        const auto dts = demuxer.seconds(packet->dts);
        // Without ascending timestamps, the frame count would be a guess.
        if (!pts || !dts || *dts < last_dts) return {};
        if (*dts >= end) break;
        last_dts = *dts;
        if (*pts < end && choice_->decodes(*packet, *demuxer.stream().codecpar)) shown.push_back(*pts);
        keys += packet->flags & AV_PKT_FLAG_KEY ? 1 : 0;
        if (packet->flags & AV_PKT_FLAG_KEY && *pts <= end) {
            key_before = last_key;
            last_key = packets;
        }
        ++packets;
    }
    // Some files mark every packet as a key frame, which is implausible for these codecs.
    if (keys == packets && has_inter_frames(demuxer)) return {};
    std::ranges::sort(shown);
    SeekPoint point{key_before, FrameNumbers(rate)};
    for (const double time_before : shown) point.numbers(time_before - origin());
    return point;
}

VideoReader::Timed VideoReader::next() {
    while (decoder_) {
        auto image = decoder_->next();
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
    const auto near = given_ > 0 ? find(last_, 0) : SeekPoint{};
    if (near.packets > start_.packets) {
        open(near);
        pass_until_ = last_;
    } else {
        open(start_);
        pass_frames_ = given_;
    }
}

}  // namespace vvr::media
