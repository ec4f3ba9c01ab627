#include "core/video/file_source.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.h"
#include "core/video/stream_info.h"

namespace vvr {

FileSource::FileSource(Input input, const SourceOptions& options)
    : options_(options), reader_(std::move(input), options.rate, options.threads) {
    auto first = reader_.next();
    const auto& name = reader_.input().name;
    if (!first.image) {
        throw Error(
            ErrorKind::not_video,
            fmt::format(
                "'{}' has video ({}), but no frame of it decodes: {} damaged packets, {}; `ffprobe` on it may say more",
                name, avcodec_get_name(reader_.demuxer().stream().codecpar->codec_id), reader_.damaged(),
                reader_.demuxer().log().text(AVERROR_INVALIDDATA)));
    }
    const Demuxer& demuxer = reader_.demuxer();
    tick_ = av_q2d(demuxer.stream().time_base);
    orientation_ = orientation_of(demuxer.stream());
    info_ = describe(demuxer, name, *first.image);
    if (options.begin) info_.created = options.begin;
    field_size_ = field_size_for(info_.size, options_.field_size);
    ahead_ = std::make_unique<DecodedFrame>(DecodedFrame{index_++, first.time, orientation_, std::move(first.image)});
}

void FileSource::rewind() {
    stored_.reset();
    seek(0);
}

void FileSource::seek(double seconds) {
    ahead_.reset();
    // Between two ticks of the container's clock, so that counting and decoding agree on which side a frame lies.
    from_ = (std::floor(seconds / tick_) - 0.5) * tick_;
    if (stored_ && stored_->is_whole()) return stored_->skip(from_);
    stored_.reset();
    start_ = from_ > 0 ? reader_.find(from_) : Start{};
    reader_.rewind(start_);
    index_ = start_.packets > 0 ? start_.frames : 0;
}

std::unique_ptr<DecodedFrame> FileSource::next() {
    if (ahead_) return std::move(ahead_);
    if (stored_) return stored_->next();
    for (;;) {
        auto [image, time] = reader_.next();
        if (!image) {
            reader_.close();
            return nullptr;
        }
        if (start_.packets == 0 || time >= from_) {
            return std::make_unique<DecodedFrame>(DecodedFrame{index_++, time, orientation_, std::move(image)});
        }
        reader_.forget_damage();
    }
}

std::vector<Frame> FileSource::sample(int count) {
    // Every open reader holds the clip's index: 24 MB for six hours.
    ahead_.reset();
    reader_.close();
    stored_.reset();
    const ClipSampler sampler(
        {reader_.input(), options_, field_size_, orientation_, reader_.origin(), reader_.threaded()});
    auto frames = sampler.sample(count, stored_);
    if (stored_) return frames;
    if (frames.empty()) return FrameSource::sample(count);
    rewind();
    return frames;
}

}  // namespace vvr
