#include "core/media/frame_sampler.h"

#include <functional>
#include <limits>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/media/container.h"
#include "core/media/decoder.h"
#include "core/media/demuxer.h"

namespace vvr::media {

double FootageTime::operator()(double time) {
    const std::int64_t before = numbers_.last();
    const double apart = time - std::exchange(last_, time);
    if (numbers_(time) > before + 1) gaps_ += apart;
    return time - gaps_;
}

double KeyFrames::scan(const Input& input, double rate, double begin) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    if (files_.empty()) begin_ = end_ = begin;
    files_.push_back(input);
    const auto packet = av::make_packet();
    double first = std::numeric_limits<double>::infinity();
    double last = -std::numeric_limits<double>::infinity();
    double last_key = last;
    while (demuxer.read(*packet)) {
        const auto time = demuxer.seconds(stamp_of(*packet));
        if (!time) continue;
        first = std::min(first, *time);
        if (*time > last) {
            last = *time;
            end_ = footage_(begin + last - first);
        }
        if (!(packet->flags & AV_PKT_FLAG_KEY) || *time < last_key) continue;
        last_key = *time;
        ++seen_;
        if (!sampler_.wants(end_)) continue;
        sampler_.keep(end_, {files_.size() - 1, begin + *time - first, end_, av::copy_of(*packet)});
    }
    unread_ += demuxer.damaged();
    if (last < first) return begin;
    end_ += demuxer.frame_duration();
    return begin + last - first + demuxer.frame_duration();
}

/// Of many key frames, the sampler leaves at least about half as many as requested, so that many are enough if they are
/// as evenly spread. An encoder that adds a key frame where something happens has most of them there.
bool KeyFrames::are_enough(std::span<const KeyPacket> keys) const {
    if (seen_ >= count_) return true;
    constexpr double most_apart = 1.0 / 8;  // of the whole
    if (2 * std::ssize(keys) < count_) return false;
    double widest = end_ - keys.back().footage;
    double before = begin_;
    for (const KeyPacket& key : keys) widest = std::max(widest, key.footage - std::exchange(before, key.footage));
    return widest <= most_apart * (end_ - begin_);
}

std::vector<Frame> KeyFrames::decode(double rate, int threads, Scaler& scale) {
    const std::vector<KeyPacket> keys = sampler_.take();
    if (!are_enough(keys)) return {};
    std::vector<Frame> frames;
    for (auto key = keys.begin(); key != keys.end();) {
        const Input& input = files_[key->file];
        Demuxer demuxer(input, Demuxer::Kind::video, rate);
        // In software: for these few frames, opening hardware would take longer.
        KeyFrameDecoder decoder(demuxer, input.name, threads);
        const auto end = std::find_if(key, keys.end(), [&](const KeyPacket& k) { return k.file != key->file; });
        for (auto sent = key; key != end; ++key) {
            for (; sent != end && decoder.has_room(); ++sent) decoder.send(*sent->packet);
            auto image = decoder.receive();
            if (image) frames.push_back(scale({0, key->time, orientation_of(demuxer.stream()), std::move(image)}));
        }
    }
    if (frames.size() < keys.size() / 2 + 1) frames.clear();
    return frames;
}

namespace {

struct ScannedPacket {
    std::int64_t stamp = 0;  ///< presentation timestamp
    double time = 0;         ///< of its frame, seconds; only in ScannedFile::shown
    bool is_key = false;
    bool is_referenced = false;
};

struct ScannedFile {
    std::vector<ScannedPacket> packets;  ///< in decoding order
    std::vector<ScannedPacket> shown;    ///< those of frames that are shown, in presentation order
};

/// Reads all packets. Empty if one has no timestamp or can't be read, or if two frames have the time_tolerance.
ScannedFile scan(const Input& input, double rate) {
    Demuxer demuxer(input, Demuxer::Kind::video, rate);
    const AVCodecParameters& stream = *demuxer.stream().codecpar;
    ScannedFile file;
    const auto packet = av::make_packet();
    while (demuxer.read(*packet)) {
        if (packet->pts == AV_NOPTS_VALUE) return {};
        file.packets.push_back(
            {packet->pts, 0, (packet->flags & AV_PKT_FLAG_KEY) != 0, is_referenced(*packet, stream)});
        if (!(packet->flags & AV_PKT_FLAG_DISCARD)) file.shown.push_back(file.packets.back());
    }
    std::ranges::sort(file.shown, {}, &ScannedPacket::stamp);
    const bool has_twins =
        std::ranges::adjacent_find(file.shown, std::ranges::equal_to(), &ScannedPacket::stamp) != file.shown.end();
    if (has_twins || demuxer.damaged() > 0) return {};
    StampClock clock(demuxer.frame_duration());
    for (ScannedPacket& one : file.shown) one.time = clock(demuxer.seconds(one.stamp));
    return file;
}

/// The presentation timestamps of the samples, ascending.
std::vector<std::int64_t> choose_samples(std::span<const ScannedPacket> shown, double rate, int count) {
    TimeSampler<std::int64_t> sampler(count);
    FootageTime footage(rate);
    for (const ScannedPacket& one : shown) {
        const double time = footage(one.time);
        if (sampler.wants(time)) sampler.keep(time, one.stamp);
    }
    return sampler.take();
}

/// The presentation timestamps, ascending, of the packets that must be decoded for these samples: they, and packets
/// before them to which other frames refer, back to the key frame.
std::vector<std::int64_t> needed_for(std::span<const std::int64_t> samples, std::span<const ScannedPacket> packets) {
    std::vector<std::int64_t> needed;
    std::int64_t first = std::numeric_limits<std::int64_t>::max();  // of the samples of this group
    for (auto i = packets.rbegin(); i != packets.rend(); ++i) {
        const bool is_sample = std::ranges::binary_search(samples, i->stamp);
        if (is_sample) first = std::min(first, i->stamp);
        const bool is_before_sample = first != std::numeric_limits<std::int64_t>::max();
        if (is_sample || (is_before_sample && i->is_referenced)) needed.push_back(i->stamp);
        // Frames that are shown before their key frame may also refer to the group before.
        if (i->is_key && first >= i->stamp) first = std::numeric_limits<std::int64_t>::max();
    }
    std::ranges::sort(needed);
    return needed;
}

}  // namespace

std::vector<Frame> sample_needed(const Input& input, const SourceOptions& options, double rate, int count,
                                 Scaler& scale) {
    const ScannedFile file = scan(input, options.rate);
    const std::vector<std::int64_t> samples = choose_samples(file.shown, rate, count);
    if (samples.empty()) return {};
    const std::vector<std::int64_t> needed = needed_for(samples, file.packets);
    Demuxer demuxer(input, Demuxer::Kind::video, options.rate);
    Decoder decoder(
        demuxer, input.name, options.threads,
        [&](const AVPacket& packet) { return std::ranges::binary_search(needed, packet.pts); }, *options.hwaccel);
    std::vector<Frame> frames;
    while (auto image = decoder.next()) {
        if (!std::ranges::binary_search(samples, image->pts)) continue;
        const double time = demuxer.seconds(image->pts).value_or(0);
        frames.push_back(scale({0, time, orientation_of(demuxer.stream()), std::move(image)}));
    }
    std::ranges::sort(frames, {}, &Frame::pts);
    // A decoder may withhold frames before a key frame at which it can't start.
    const bool are_most = 2 * frames.size() > samples.size();
    return are_most && decoder.damaged() == 0 && !decoder.stopped() ? std::move(frames) : std::vector<Frame>{};
}

std::string text_of_unread(const std::string& name) {
    return fmt::format("'{}': vvr learned the empty scene without a part of the file that it could not read", name);
}

std::vector<Frame> FrameSource::sample(int count) {
    std::vector<Frame> frames = sample_all(count);
    rewind();
    return frames;
}

std::vector<Frame> FrameSource::sample_all(int count) {
    rewind();
    Scaler scale(*this);
    TimeSampler<Frame> sampler(count);
    FootageTime footage(info().rate);
    while (const auto decoded = next()) {
        const double time = footage(decoded->pts);
        if (sampler.wants(time)) sampler.keep(time, scale(*decoded));
    }
    return sampler.take();
}

void FrameSource::seek(double) {
    rewind();
}

void FrameSource::read_again(std::span<const double> times,
                             const std::function<void(std::shared_ptr<DecodedFrame>)>& sink) {
    constexpr double close = 60;  // seconds: where seeking leads farther back, reading goes on instead
    std::shared_ptr<DecodedFrame> frame;
    bool seeks = true;
    for (const double time : times) {
        if (seeks) {
            seek(time);
            frame = next();
            seeks = frame && frame->pts >= time - close;
        }
        while (frame && frame->pts < time - time_tolerance) frame = next();
        if (frame && frame->pts <= time + time_tolerance) sink(frame);
    }
}

}  // namespace vvr::media
