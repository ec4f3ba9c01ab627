#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vvr::video {

/// Converts a container's presentation timestamps to times that start at 0 and never decrease.
class StampClock {
  public:
    /// \param duration seconds per frame, used if a timestamp is missing
    explicit StampClock(double duration) : duration_(duration) {}

    /// \param origin timestamp of the clip's first frame, seconds
    StampClock(double duration, double origin) : duration_(duration), origin_(origin) {}

    /// The time of the next frame, in seconds. A small step back repeats the last time. A large one means that the
    /// camera set its clock, and time continues from the last frame.
    /// \param stamp seconds on the container's clock
    double operator()(std::optional<double> stamp);

    /// The first timestamp, seconds. Empty until a frame has one.
    std::optional<double> origin() const { return origin_; }

  private:
    double next() const;

    double duration_;
    std::optional<double> origin_;
    std::optional<double> last_;
};

/// Converts a live stream's presentation timestamps to times that start at 0 and never decrease. Within a connection,
/// time follows the timestamps. Across a reconnection, it follows the reader's clock.
class LiveClock {
  public:
    /// \param duration seconds per frame
    explicit LiveClock(double duration) : duration_(duration) {}

    /// Call it after a reconnection: later timestamps are unrelated to earlier ones.
    void restart() { stamp_.reset(); }

    /// The time of the next frame, in seconds.
    /// \param stamp seconds on the container's clock
    /// \param arrival when the frame arrived, seconds on a monotonic clock
    double operator()(std::optional<double> stamp, double arrival);

  private:
    double step(const std::optional<double>& stamp, double arrival) const;

    double duration_;
    std::optional<double> time_;
    std::optional<double> stamp_;
    double arrival_ = 0;
};

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

}  // namespace vvr::video
