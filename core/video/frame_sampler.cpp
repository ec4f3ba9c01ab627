#include "core/video/frame_sampler.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/video/container.h"
#include "core/video/decoder.h"
#include "core/video/demuxer.h"

namespace vvr::video {

double KeyFrames::scan(const Input& input, double rate, double begin) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    if (files_.empty()) begin_ = begin;
    files_.push_back(input);
    const auto packet = av::make_packet();
    double first = std::numeric_limits<double>::infinity();
    double last = -std::numeric_limits<double>::infinity();
    double last_key = last;
    while (demuxer.read(*packet)) {
        const auto time = demuxer.seconds(packet->pts != AV_NOPTS_VALUE ? packet->pts : packet->dts);
        if (!time) continue;
        first = std::min(first, *time);
        last = std::max(last, *time);
        if (!(packet->flags & AV_PKT_FLAG_KEY) || *time < last_key) continue;
        last_key = *time;
        ++seen_;
        const double at = begin + *time - first;
        if (!sampler_.wants(at)) continue;
        av::Ptr<AVPacket> copy(av_packet_clone(packet.get()));
        if (!copy) throw Error(ErrorCode::out_of_memory, "out of memory while reading the video; give vvr more memory");
        sampler_.keep(at, {files_.size() - 1, at, std::move(copy)});
    }
    unread_ += demuxer.damaged();
    end_ = last < first ? begin : begin + last - first + demuxer.frame_duration();
    return end_;
}

/// Of many key frames, the sampler leaves at least about half as many as requested, so that many are enough if they are
/// as evenly spread. An encoder that adds a key frame where something happens has most of them there.
bool KeyFrames::are_enough(std::span<const KeyPacket> keys) const {
    if (seen_ >= count_) return true;
    constexpr double most_apart = 1.0 / 8;  // of the whole
    if (2 * std::ssize(keys) < count_) return false;
    double widest = end_ - keys.back().time;
    double before = begin_;
    for (const KeyPacket& key : keys) widest = std::max(widest, key.time - std::exchange(before, key.time));
    return widest <= most_apart * (end_ - begin_);
}

std::vector<Frame> KeyFrames::decode(double rate, Scaler& scale) {
    const std::vector<KeyPacket> keys = sampler_.take();
    if (!are_enough(keys)) return {};
    std::vector<Frame> frames;
    for (auto key = keys.begin(); key != keys.end();) {
        const Input& input = files_[key->file];
        Demuxer demuxer(input, Demuxer::Kind::video, rate);
        // In software: for these few frames, opening hardware would take longer.
        Decoder decoder(demuxer, input.name, 1);
        const auto end = std::find_if(key, keys.end(), [&](const KeyPacket& k) { return k.file != key->file; });
        for (; key != end; ++key) {
            auto image = decoder.decode_alone(*key->packet);
            if (image) frames.push_back(scale({0, key->time, orientation_of(demuxer.stream()), std::move(image)}));
        }
    }
    if (frames.size() < keys.size() / 2 + 1) frames.clear();
    return frames;
}

namespace {

/// The presentation timestamps of the sampled frames, ascending. Empty if a packet has none or can't be read, or if two
/// have the same.
std::vector<std::int64_t> sampled_stamps(const Input& input, double rate, int count) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    std::vector<std::int64_t> stamps;
    const auto packet = av::make_packet();
    while (demuxer.read(*packet)) {
        if (packet->pts == AV_NOPTS_VALUE) return {};
        if (!(packet->flags & AV_PKT_FLAG_DISCARD)) stamps.push_back(packet->pts);
    }
    if (demuxer.damaged() > 0) return {};
    std::ranges::sort(stamps);
    if (std::ranges::adjacent_find(stamps) != stamps.end()) return {};
    StampClock clock(demuxer.frame_duration());
    TimeSampler<std::int64_t> sampler(count);
    for (const std::int64_t stamp : stamps) {
        const double time = clock(demuxer.seconds(stamp));
        if (sampler.wants(time)) sampler.keep(time, stamp);
    }
    return sampler.take();
}

}  // namespace

std::vector<Frame> sample_needed(const Input& input, const SourceOptions& options, int count, Scaler& scale) {
    const std::vector<std::int64_t> stamps = sampled_stamps(input, options.rate, count);
    if (stamps.empty()) return {};
    const auto is_sampled = [&](std::int64_t stamp) { return std::ranges::binary_search(stamps, stamp); };
    Demuxer demuxer(input, Demuxer::Kind::video, options.rate);
    const AVCodecParameters& stream = *demuxer.stream().codecpar;
    Decoder decoder(
        demuxer, input.name, options.threads,
        [&](const AVPacket& packet) { return is_sampled(packet.pts) || is_referenced(packet, stream); },
        *options.hwaccel);
    std::vector<Frame> frames;
    while (auto image = decoder.next()) {
        if (!is_sampled(image->best_effort_timestamp)) continue;
        const double time = demuxer.seconds(image->best_effort_timestamp).value_or(0);
        frames.push_back(scale({0, time, orientation_of(demuxer.stream()), std::move(image)}));
    }
    const bool complete = frames.size() == stamps.size() && decoder.damaged() == 0 && !decoder.stopped();
    return complete ? std::move(frames) : std::vector<Frame>{};
}

std::string text_of_unread(const std::string& name) {
    return fmt::format("'{}': vvr learned the empty scene without a part of the file that it could not read", name);
}

}  // namespace vvr::video
