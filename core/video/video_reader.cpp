#include "core/video/video_reader.h"

#include <algorithm>
#include <utility>

namespace vvr::video {

VideoReader::VideoReader(Input input, double rate, int threads)
    : input_(std::move(input)), rate_(rate), threads_(threads) {
    open({});
}

void VideoReader::open(const SeekPoint& start) {
    close();
    demuxer_ = std::make_unique<Demuxer>(input_, Demuxer::Kind::video, rate_);
    decoder_ = std::make_unique<Decoder>(*demuxer_, input_.name, threads_);
    threaded_ = decoder_->threaded();
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
    decoder_.reset();
    demuxer_.reset();
}

void VideoReader::rewind(const SeekPoint& start) {
    start_ = start;
    given_ = 0;
    open(start);
}

SeekPoint VideoReader::find(double time) const {
    Demuxer scan(input_, Demuxer::Kind::video, rate_);
    return find_seek_point(scan, origin() + time);
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

/// Decodes again from a little before the damage, passing over the frames that were given already.
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
