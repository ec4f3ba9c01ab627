#include "core/video/clip_sampler.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <memory>
#include <utility>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include "core/video/decoder.h"
#include "core/video/demuxer.h"
#include "core/video/scaler.h"

namespace vvr {
namespace {

/// Decodes the packets that a plan uses.
class Decoding {
  public:
    Decoding(const Input& input, const SourceOptions& options, std::vector<PacketUse> uses)
        : demuxer_(input, Demuxer::Kind::video, options.rate), decoder_(demuxer_, input.name, options.threads) {
        decoder_.follow(std::move(uses));
    }

    /// The next frame, nothing at the end or where the clip is damaged.
    AvFrame next() {
        AvFrame image = decoder_.next();
        return intact() ? std::move(image) : nullptr;
    }

    bool intact() const { return decoder_.damaged() == 0; }
    const Demuxer& demuxer() const { return demuxer_; }

  private:
    Demuxer demuxer_;
    Decoder decoder_;
};

/// A decoded frame that is going to be kept.
struct Small {
    std::int64_t stamp;
    DecodedFrame frame;
    std::optional<Frame> sample;
};

std::vector<Frame> joined(std::vector<std::vector<Frame>> parts) {
    std::vector<Frame> frames;
    for (std::vector<Frame>& part : parts) std::ranges::move(part, std::back_inserter(frames));
    return frames;
}

}  // namespace

/// The room for a clip that is decoded but once, for all threads that fill it.
class KeepingRoom {
  public:
    explicit KeepingRoom(std::size_t frames) : frames_(static_cast<double>(frames)) {}

    /// Takes so many bytes for one frame more. There is room as long as there is some, by what came so far, for all
    /// that are to come.
    void take(std::size_t bytes) {
        constexpr std::size_t room = 100'000'000;  // less than drawing takes when they have been given back
        constexpr std::size_t telling = 50;
        const std::size_t taken = bytes_ += bytes;
        const std::size_t count = ++count_;
        if (taken > room) close();
        if (count >= telling && static_cast<double>(taken) / static_cast<double>(count) * frames_ > 1.2 * room) close();
    }

    void close() { open_ = false; }
    bool open() const { return open_; }

  private:
    double frames_;
    std::atomic<std::size_t> bytes_ = 0;
    std::atomic<std::size_t> count_ = 0;
    std::atomic<bool> open_ = true;
};

DecodedFrame KeptClip::next() {
    for (FrameStore& part : parts_) {
        AvFrame image = part.pop();
        if (!image) continue;
        const std::size_t index = given_++;
        return {static_cast<std::int64_t>(index), times_[index], orientation_, std::move(image)};
    }
    return {};
}

void KeptClip::pass(double time) {
    while (given_ < times_.size() && times_[given_] < time) next();
}

std::vector<Frame> ClipSampler::sample(int count, std::optional<KeptClip>& kept) const {
    std::vector<Frame> frames = sample_key_frames(count);
    if (!frames.empty()) return frames;
    const ClipPackets packets = [&] {
        Demuxer scan(clip_.input, Demuxer::Kind::video, clip_.options.rate);
        return scan_packets(scan);
    }();
    if (packets.stamps.empty()) return {};
    frames = sample_keeping(packets, count, kept);
    return frames.empty() ? sample_planned(packets, count) : frames;
}

/// None where the clip has fewer key frames than asked for, or where they don't decode by themselves.
std::vector<Frame> ClipSampler::sample_key_frames(int count) const {
    Demuxer scan(clip_.input, Demuxer::Kind::video, clip_.options.rate);
    const auto keys = find_key_packets(scan, count);
    if (keys.seen < count) return {};

    Decoder decoder(scan, clip_.input.name, 1);
    Scaler scale(clip_.field_size, clip_.options.colour);
    std::vector<Frame> frames;
    for (const auto& packet : keys.kept)
        if (auto image = decoder.decode_alone(*packet)) frames.push_back(scale(without_index(scan, std::move(image))));
    if (frames.size() < keys.kept.size() / 2 + 1) return {};
    return frames;
}

/// The frames that sampling all of them would give, where there is room to keep the clip, so that it is decoded but
/// once. None where there isn't, where the clip is damaged, or its packets' times are not its frames'.
std::vector<Frame> ClipSampler::sample_keeping(const ClipPackets& packets, int count,
                                               std::optional<KeptClip>& kept) const {
    const std::vector<std::int64_t> samples = sampled_stamps(packets, count);
    auto plans = share_out(plan_decoding(packets, packets.stamps));
    KeepingRoom room(packets.stamps.size());
    std::vector<FrameStore> stores(plans.size());
    std::vector<std::vector<Frame>> parts(plans.size());
    oneapi::tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) {
        if (!decode(std::move(plans[i]), samples, room, stores[i], parts[i])) room.close();
    });
    if (!room.open()) return {};
    kept.emplace(std::move(stores), packets.times, clip_.orientation);
    return joined(std::move(parts));
}

/// The same without what they don't depend on.
std::vector<Frame> ClipSampler::sample_planned(const ClipPackets& packets, int count) const {
    auto plans = share_out(plan_decoding(packets, sampled_stamps(packets, count)));
    std::vector<std::vector<Frame>> parts(plans.size());
    std::atomic<bool> whole = true;
    oneapi::tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) {
        if (!decode(std::move(plans[i]), parts[i])) whole = false;
    });
    return whole ? joined(std::move(parts)) : std::vector<Frame>{};
}

/// Where one decoder has no threads of its own, several share the clip; a server is asked but once at a time.
std::vector<DecodingPlan> ClipSampler::share_out(const DecodingPlan& plan) const {
    const bool alone = clip_.threaded || !is_local(clip_.input);
    return cut_plan(plan, alone ? 1 : oneapi::tbb::this_task_arena::max_concurrency());
}

/// \returns false where not all of the plan's frames come
bool ClipSampler::decode(DecodingPlan plan, std::vector<Frame>& frames) const {
    Decoding decoding(clip_.input, clip_.options, std::move(plan.uses));
    Scaler scale(clip_.field_size, clip_.options.colour);
    while (frames.size() < plan.stamps.size()) {
        AvFrame image = decoding.next();
        if (!image) return false;
        if (image->best_effort_timestamp == plan.stamps[frames.size()])
            frames.push_back(scale(without_index(decoding.demuxer(), std::move(image))));
    }
    return true;
}

/// Keeps all frames of a plan, and gives those that are samples.
/// \returns false where others come, or there is no room
bool ClipSampler::decode(DecodingPlan plan, const std::vector<std::int64_t>& samples, KeepingRoom& room,
                         FrameStore& store, std::vector<Frame>& frames) const {
    using oneapi::tbb::filter_mode;
    using oneapi::tbb::make_filter;
    Decoding decoding(clip_.input, clip_.options, std::move(plan.uses));
    oneapi::tbb::enumerable_thread_specific<Scaler> scalers(
        [this] { return Scaler(clip_.field_size, clip_.options.colour); });
    const auto read = make_filter<void, std::shared_ptr<DecodedFrame>>(
        filter_mode::serial_in_order, [&](oneapi::tbb::flow_control& control) -> std::shared_ptr<DecodedFrame> {
            AvFrame image = room.open() ? decoding.next() : nullptr;
            if (image) return std::make_shared<DecodedFrame>(without_index(decoding.demuxer(), std::move(image)));
            control.stop();
            return nullptr;
        });
    const auto shrink = make_filter<std::shared_ptr<DecodedFrame>, std::shared_ptr<Small>>(
        filter_mode::parallel, [&](const std::shared_ptr<DecodedFrame>& decoded) {
            Scaler& scale = scalers.local();
            Small small{decoded->image->best_effort_timestamp, scale.shrink(*decoded), {}};
            if (std::ranges::binary_search(samples, small.stamp)) small.sample = scale(small.frame);
            return std::make_shared<Small>(std::move(small));
        });
    const auto keep = make_filter<std::shared_ptr<Small>, void>(
        filter_mode::serial_in_order, [&](const std::shared_ptr<Small>& small) {
            const bool expected = store.size() < plan.stamps.size() && plan.stamps[store.size()] == small->stamp;
            const std::size_t before = store.bytes();
            if (!expected || !store.push(*small->frame.image)) return room.close();
            room.take(store.bytes() - before);
            if (small->sample) frames.push_back(std::move(*small->sample));
        });
    const int threads = oneapi::tbb::this_task_arena::max_concurrency();
    oneapi::tbb::parallel_pipeline(2 * static_cast<std::size_t>(threads), read & shrink & keep);
    return decoding.intact() && store.size() == plan.stamps.size();
}

DecodedFrame ClipSampler::without_index(const Demuxer& demuxer, AvFrame image) const {
    const double pts = demuxer.seconds(image->best_effort_timestamp).value_or(clip_.origin) - clip_.origin;
    return {0, pts, clip_.orientation, std::move(image)};
}

}  // namespace vvr
