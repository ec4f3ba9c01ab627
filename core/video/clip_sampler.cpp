#include "core/video/clip_sampler.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include <lz4.h>

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include "core/video/decoder.h"
#include "core/video/demuxer.h"
#include "core/video/scaler.h"

namespace vvr::video {
namespace {

using Bytes = Plane<std::uint8_t>;

/// \param to memory for the result, larger than it
/// \returns the compressed bytes, a part of `to`
std::span<const char> compress(const Bytes& from, std::vector<char>& to) {
    const int length = static_cast<int>(from.pixels().size());
    to.resize(static_cast<std::size_t>(LZ4_compressBound(length)));
    constexpr int acceleration = 16;
    const int written = LZ4_compress_fast(reinterpret_cast<const char*>(from.pixels().data()), to.data(), length,
                                          static_cast<int>(to.size()), acceleration);
    return std::span(to).first(static_cast<std::size_t>(written));
}

Bytes decompressed(std::span<const char> from, Size size) {
    auto bytes = Bytes::for_overwrite(size);
    LZ4_decompress_safe(from.data(), reinterpret_cast<char*>(bytes.pixels().data()), static_cast<int>(from.size()),
                        static_cast<int>(bytes.pixels().size()));
    return bytes;
}

/// `here` becomes how `other` differs from it, modulo 256.
void difference(Bytes& here, const Bytes& other) {
    std::uint8_t* const to = here.pixels().data();
    const std::uint8_t* const from = other.pixels().data();
    const std::size_t count = here.pixels().size();
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(from[i] - to[i]);
}

/// Undoes `difference`: adds the change, modulo 256.
void add(const Bytes& change, Bytes& here) {
    std::uint8_t* const to = here.pixels().data();
    const std::uint8_t* const by = change.pixels().data();
    const std::size_t count = here.pixels().size();
    for (std::size_t i = 0; i < count; ++i) to[i] = static_cast<std::uint8_t>(to[i] + by[i]);
}

}  // namespace

bool FrameStore::push(ScaledPicture picture) {
    if (!pushed_) pushed_ = {Bytes(picture.planes.size()), picture.matrix};
    Bytes& before = pushed_->planes;
    if (before.size() != picture.planes.size() || pushed_->matrix != picture.matrix) return false;
    difference(before, picture.planes);
    const auto packed = compress(before, scratch_);
    packed_.emplace_back(packed.begin(), packed.end());
    bytes_ += packed.size();
    pushed_ = std::move(picture);
    return true;
}

std::optional<ScaledPicture> FrameStore::pop() {
    if (packed_.empty()) return {};
    const Bytes change = decompressed(packed_.front(), pushed_->planes.size());
    bytes_ -= packed_.front().size();
    packed_.pop_front();
    if (!popped_) popped_ = {Bytes(change.size()), pushed_->matrix};
    add(change, popped_->planes);
    return popped_;
}

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

std::vector<Frame> concatenated(std::vector<std::vector<Frame>> parts) {
    std::vector<Frame> frames;
    for (std::vector<Frame>& part : parts) std::ranges::move(part, std::back_inserter(frames));
    return frames;
}

}  // namespace

/// What a clip takes that is being stored, counted by all threads that decode it.
class StoredBytes {
  public:
    explicit StoredBytes(std::size_t frames) : frames_(static_cast<double>(frames)) {}

    /// Counts one frame more. Gives up where the clip takes too much, or, by its frames so far, is going to.
    void add(std::size_t bytes) {
        constexpr std::size_t limit = 100'000'000;  // less than drawing takes after they have been freed
        constexpr std::size_t frames_to_judge = 50;
        const std::size_t taken = bytes_ += bytes;
        const std::size_t count = ++count_;
        if (taken > limit) give_up();
        if (count >= frames_to_judge &&
            static_cast<double>(taken) / static_cast<double>(count) * frames_ > 1.2 * limit) {
            give_up();
        }
    }

    void give_up() { given_up_ = true; }
    bool given_up() const { return given_up_; }

  private:
    double frames_;
    std::atomic<std::size_t> bytes_ = 0;
    std::atomic<std::size_t> count_ = 0;
    std::atomic<bool> given_up_ = false;
};

std::unique_ptr<DecodedFrame> StoredClip::next() {
    for (FrameStore& part : parts_) {
        auto picture = part.pop();
        if (!picture) continue;
        const std::size_t index = read_++;
        return std::make_unique<DecodedFrame>(
            DecodedFrame{static_cast<std::int64_t>(index), times_[index], orientation_, nullptr, std::move(picture)});
    }
    return nullptr;
}

void StoredClip::skip(double time) {
    while (read_ < times_.size() && times_[read_] < time) next();
}

std::vector<Frame> ClipSampler::sample(int count, std::optional<StoredClip>& stored) const {
    std::vector<Frame> frames = sample_key_frames(count);
    if (!frames.empty()) return frames;
    const ClipPackets packets = [&] {
        Demuxer scan(clip_.input, Demuxer::Kind::video, clip_.options.rate);
        return scan_packets(scan);
    }();
    if (packets.stamps.empty()) return {};
    frames = sample_all(packets, count, stored);
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
    for (const auto& packet : keys.kept) {
        if (auto image = decoder.decode_alone(*packet)) frames.push_back(scale(without_index(scan, std::move(image))));
    }
    if (frames.size() < keys.kept.size() / 2 + 1) return {};
    return frames;
}

/// Decodes and stores the whole clip, so that it is decoded only once. Nothing where it takes too much memory, is
/// damaged, or has other frames than its packets' times say.
std::vector<Frame> ClipSampler::sample_all(const ClipPackets& packets, int count,
                                           std::optional<StoredClip>& stored) const {
    const std::vector<std::int64_t> samples = sampled_stamps(packets, count);
    const auto plans = split_for_threads(plan_decoding(packets, packets.stamps));
    StoredBytes bytes(packets.stamps.size());
    std::vector<FrameStore> stores(plans.size());
    std::vector<std::vector<Frame>> parts(plans.size());
    oneapi::tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) {
        if (!decode(plans[i], samples, bytes, stores[i], parts[i])) bytes.give_up();
    });
    if (bytes.given_up()) return {};
    stored.emplace(std::move(stores), packets.times, clip_.orientation);
    return concatenated(std::move(parts));
}

/// Decodes only the samples and the frames that they depend on.
std::vector<Frame> ClipSampler::sample_planned(const ClipPackets& packets, int count) const {
    const auto plans = split_for_threads(plan_decoding(packets, sampled_stamps(packets, count)));
    std::vector<std::vector<Frame>> parts(plans.size());
    std::atomic<bool> whole = true;
    oneapi::tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) {
        if (!decode(plans[i], parts[i])) whole = false;
    });
    return whole ? concatenated(std::move(parts)) : std::vector<Frame>{};
}

/// Cuts a plan into parts for several decoders, unless one decoder has threads of its own. A server is asked by one
/// decoder at a time.
std::vector<DecodingPlan> ClipSampler::split_for_threads(const DecodingPlan& plan) const {
    const bool alone = clip_.threaded || !is_local(clip_.input);
    return cut_plan(plan, alone ? 1 : oneapi::tbb::this_task_arena::max_concurrency());
}

/// \returns false where not all of the plan's frames come
bool ClipSampler::decode(const DecodingPlan& plan, std::vector<Frame>& frames) const {
    Decoding decoding(clip_.input, clip_.options, plan.uses);
    Scaler scale(clip_.field_size, clip_.options.colour);
    while (frames.size() < plan.stamps.size()) {
        AvFrame image = decoding.next();
        if (!image) return false;
        if (image->best_effort_timestamp == plan.stamps[frames.size()]) {
            frames.push_back(scale(without_index(decoding.demuxer(), std::move(image))));
        }
    }
    return true;
}

/// Stores all frames of a plan, and adds its samples to `frames`.
/// \returns false where other frames come, or storing them was given up
bool ClipSampler::decode(const DecodingPlan& plan, const std::vector<std::int64_t>& samples, StoredBytes& bytes,
                         FrameStore& store, std::vector<Frame>& frames) const {
    Decoding decoding(clip_.input, clip_.options, plan.uses);
    Scaler scale(clip_.field_size, clip_.options.colour);
    for (const std::int64_t stamp : plan.stamps) {
        AvFrame image = bytes.given_up() ? nullptr : decoding.next();
        if (!image || image->best_effort_timestamp != stamp) return false;
        DecodedFrame frame = scale.shrink(without_index(decoding.demuxer(), std::move(image)));
        if (std::ranges::binary_search(samples, stamp)) frames.push_back(scale(frame));
        const std::size_t before = store.bytes();
        if (!store.push(std::move(*frame.scaled))) return false;
        bytes.add(store.bytes() - before);
    }
    return decoding.next() == nullptr && decoding.intact();
}

DecodedFrame ClipSampler::without_index(const Demuxer& demuxer, AvFrame image) const {
    const double pts = demuxer.seconds(image->best_effort_timestamp).value_or(clip_.origin) - clip_.origin;
    return {0, pts, clip_.orientation, std::move(image)};
}

}  // namespace vvr::video
