#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/media/frame_source.h"
#include "core/media/input.h"
#include "core/media/scaler.h"
#include "core/media/video_reader.h"

// Samples of a video's frames, spread in time.
namespace vvr::media {

/// Keeps at most `capacity` items, spread evenly in time over a stream of unknown length. When it is full, it widens
/// the gap between items and drops the items that are too close.
template <class Item>
class TimeSampler {
  public:
    explicit TimeSampler(int capacity) : capacity_(static_cast<std::size_t>(std::max(1, capacity))) {}

    /// Whether an item at `time` is to be kept. Makes room for it. Times must not decrease.
    bool wants(double time) {
        if (kept_.size() == capacity_ && is_due(time)) thin(time);
        return is_due(time);
    }

    /// \pre wants(time)
    void keep(double time, Item item) { kept_.emplace_back(time, std::move(item)); }

    std::vector<Item> take() {
        std::vector<Item> items;
        for (auto& [time, item] : kept_) items.push_back(std::move(item));
        kept_.clear();
        return items;
    }

  private:
    bool is_due(double time) const { return kept_.empty() || time >= kept_.back().first + gap_; }

    void thin(double now) {
        const double average = (now - kept_.front().first) / static_cast<double>(capacity_);
        // Slightly less than twice the average, so that rounding drops no frames of a constant rate.
        gap_ = std::max(2 * gap_, 1.999 * average);
        std::size_t used = 1;
        for (std::size_t i = 1; i < kept_.size(); ++i) {
            if (kept_[i].first >= kept_[used - 1].first + gap_) {
                if (i != used) kept_[used] = std::move(kept_[i]);
                ++used;
            }
        }
        used = std::max<std::size_t>(1, std::min(used, capacity_ - 1));
        kept_.erase(kept_.begin() + static_cast<std::ptrdiff_t>(used), kept_.end());
    }

    std::size_t capacity_;
    double gap_ = 0;
    std::vector<std::pair<double, Item>> kept_;
};

/// Seconds of footage before a frame: its time without the gaps before it. Otherwise most samples of a recording with a
/// long gap would be the frames beside the gap.
class FootageTime {
  public:
    /// \param rate usual frames per second; 0 = unknown, so there are no gaps
    explicit FootageTime(double rate) : numbers_(rate) {}

    /// \param time of the next frame, seconds; must not decrease
    double operator()(double time);

  private:
    FrameNumbers numbers_;
    double last_ = 0;
    double gaps_ = 0;
};

/// Samples key frames, spread in time over one or more consecutive files. Each is decoded on its own. All packets are
/// read, which is cheap compared with decoding and works without an index or accurate seeking.
class KeyFrames {
  public:
    /// \param count maximum number of frames
    /// \param rate usual frames per second; 0 = unknown
    KeyFrames(int count, double rate) : count_(count), sampler_(count), footage_(rate) {}

    /// Reads the packets of a file.
    /// \param begin time of its first frame, seconds; must not decrease from file to file
    /// \returns the time of its end, seconds; `begin` if no packet has a timestamp
    double scan(const Input& input, double rate, double begin);

    /// Packets that the scans could not read.
    std::int64_t unread() const { return unread_; }

    /// Decodes the frames, in order. Empty if there are too few key frames, if they are unevenly spread, or if they
    /// don't decode on their own. Call it only once.
    /// \param threads 0 = one per core, or a single one for small pictures
    std::vector<Frame> decode(double rate, int threads, Scaler& scale);

  private:
    struct KeyPacket {
        std::size_t file = 0;
        double time = 0;     ///< of its frame, seconds
        double footage = 0;  ///< seconds of footage before it
        av::Ptr<AVPacket> packet;
    };

    bool are_enough(std::span<const KeyPacket> keys) const;

    int count_;
    TimeSampler<KeyPacket> sampler_;
    std::vector<Input> files_;
    std::int64_t seen_ = 0;
    std::int64_t unread_ = 0;
    FootageTime footage_;
    double begin_ = 0;  ///< seconds of footage before the first file
    double end_ = 0;    ///< seconds of footage before the end of the last file
};

/// Samples the same frames as FrameSource::sample_all. Decodes only what they need: in a group of pictures, nothing
/// after its last sample, and before it only frames to which others refer. Of a usual clip with B frames, that is less
/// than half.
/// \returns nothing if the packets don't tell which frames these are, or if something is damaged
/// \param rate usual frames per second; 0 = unknown
std::vector<Frame> sample_needed(const Input& input, const SourceOptions& options, double rate, int count,
                                 Scaler& scale);

/// A problem: a part of the file could not be read for the samples from which the empty scene is learned.
std::string text_of_unread(const std::string& name);

}  // namespace vvr::media
