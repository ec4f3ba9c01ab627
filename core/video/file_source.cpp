#include "core/video/file_source.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "core/error.h"
#include "core/video/scaler.h"
#include "core/video/stream_info.h"

namespace vvr {

FileSource::FileSource(Input input, const SourceOptions& options)
    : options_(options), reader_(std::move(input), options.rate, options.threads) {
    auto first = reader_.next();
    const auto& name = reader_.input().name;
    if (!first.image)
        throw Error(
            ErrorKind::not_video,
            fmt::format(
                "'{}' has video ({}), but no frame of it decodes: {} damaged packets, {}; `ffprobe` on it may say more",
                name, avcodec_get_name(reader_.demuxer().stream().codecpar->codec_id), reader_.damaged(),
                reader_.demuxer().log().text(AVERROR_INVALIDDATA)));
    const Demuxer& demuxer = reader_.demuxer();
    tick_ = av_q2d(demuxer.stream().time_base);
    orientation_ = orientation_of(demuxer.stream());
    info_ = describe(demuxer, name, *first.image);
    field_size_ = field_size_for(info_.size, options_.field_size);
    ahead_ = std::make_unique<DecodedFrame>(DecodedFrame{index_++, first.time, orientation_, std::move(first.image)});
}

void FileSource::rewind() {
    seek(0);
}

void FileSource::seek(double seconds) {
    ahead_.reset();
    // Between two ticks of the container's clock, so that counting and decoding agree on which side a frame lies.
    from_ = (std::floor(seconds / tick_) - 0.5) * tick_;
    start_ = from_ > 0 ? reader_.find(from_) : Start{};
    reader_.rewind(start_);
    index_ = start_.packets > 0 ? start_.frames : 0;
}

std::unique_ptr<DecodedFrame> FileSource::next() {
    if (ahead_) return std::move(ahead_);
    for (;;) {
        auto [image, time] = reader_.next();
        if (!image) {
            reader_.close();
            return nullptr;
        }
        if (start_.packets == 0 || time >= from_)
            return std::make_unique<DecodedFrame>(DecodedFrame{index_++, time, orientation_, std::move(image)});
        reader_.forget_damage();
    }
}

std::vector<Frame> FileSource::sample(int count) {
    // Each that is open holds the clip's index, 24 MB of six hours.
    ahead_.reset();
    reader_.close();
    auto frames = sample_key_frames(count);
    if (frames.empty()) frames = sample_planned(count);
    if (frames.empty()) return FrameSource::sample(count);
    rewind();
    return frames;
}

/// None where the clip has fewer key frames than asked for, or where they don't decode by themselves.
std::vector<Frame> FileSource::sample_key_frames(int count) const {
    Demuxer scan(reader_.input(), Demuxer::Kind::video, options_.rate);
    const auto keys = find_key_packets(scan, count);
    if (keys.seen < count) return {};

    Decoder decoder(scan, reader_.input().name, 1);
    Scaler scale(*this);
    std::vector<Frame> frames;
    for (const auto& packet : keys.kept)
        if (auto image = decoder.decode_alone(*packet)) frames.push_back(scale(without_index(scan, std::move(image))));
    if (frames.size() < keys.kept.size() / 2 + 1) return {};
    return frames;
}

/// The frames that sampling all of them would give, without decoding what they don't depend on. None where the clip is
/// damaged, or its packets' times are not its frames'.
std::vector<Frame> FileSource::sample_planned(int count) const {
    const SampledPackets plan = [&] {
        Demuxer scan(reader_.input(), Demuxer::Kind::video, options_.rate);
        return plan_samples(scan, count);
    }();
    // Where one decoder has no threads of its own, several share the clip; a server is asked but once at a time.
    const bool alone = reader_.threaded() || !reader_.input().file;
    auto plans = cut_plan(plan, alone ? 1 : oneapi::tbb::this_task_arena::max_concurrency());
    std::vector<std::vector<Frame>> parts(plans.size());
    oneapi::tbb::parallel_for(std::size_t{0}, plans.size(),
                              [&](std::size_t i) { parts[i] = decode(std::move(plans[i])); });
    std::vector<Frame> frames;
    for (std::vector<Frame>& part : parts) std::ranges::move(part, std::back_inserter(frames));
    if (frames.size() < plan.stamps.size()) frames.clear();
    return frames;
}

/// The frames of a plan; fewer where the clip is damaged, or its packets' times are not its frames'.
std::vector<Frame> FileSource::decode(SampledPackets plan) const {
    Demuxer demuxer(reader_.input(), Demuxer::Kind::video, options_.rate);
    Decoder decoder(demuxer, reader_.input().name, options_.threads);
    decoder.follow(std::move(plan.uses));
    Scaler scale(*this);
    std::vector<Frame> frames;
    while (frames.size() < plan.stamps.size()) {
        auto image = decoder.next();
        if (!image || decoder.damaged() > 0) return {};
        if (image->best_effort_timestamp == plan.stamps[frames.size()])
            frames.push_back(scale(without_index(demuxer, std::move(image))));
    }
    return frames;
}

DecodedFrame FileSource::without_index(const Demuxer& demuxer, AvFrame image) const {
    const double origin = reader_.origin();
    const double pts = demuxer.seconds(image->best_effort_timestamp).value_or(origin) - origin;
    return {0, pts, orientation_, std::move(image)};
}

}  // namespace vvr
