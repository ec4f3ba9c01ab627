#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace vvr::video {

/// Makes the time stamps of a container into times that start at 0 and never run backwards.
class StampClock {
  public:
    /// \param duration seconds from one frame to the next, where a stamp is missing
    explicit StampClock(double duration) : duration_(duration) {}

    /// Starts with the clip's first frame at `origin` on the container's clock.
    StampClock(double duration, double origin) : duration_(duration), origin_(origin) {}

    /// The time of the next frame in order, in seconds. A small step back repeats the last time; a large one is a
    /// camera that set its clock anew, and time goes on from the last frame.
    double operator()(std::optional<double> stamp);

    /// The first frame's stamp; nothing until a frame has a stamp.
    std::optional<double> origin() const { return origin_; }

  private:
    double next() const;

    double duration_;
    std::optional<double> origin_;
    std::optional<double> last_;
};

/// Makes the time stamps of a stream that may break off and begin again into times that start at 0 and never run
/// backwards. Within a connection the stamps tell how time goes on, across a gap the clock of the reader does.
class LiveClock {
  public:
    /// \param duration seconds from a frame to the next
    explicit LiveClock(double duration) : duration_(duration) {}

    /// Stamps from here on have nothing to do with those before.
    void restart() { stamp_.reset(); }

    /// The time of the next frame, in seconds.
    /// \param arrival when it came, on any clock that runs evenly
    double operator()(std::optional<double> stamp, double arrival);

  private:
    double step(const std::optional<double>& stamp, double arrival) const;

    double duration_;
    std::optional<double> time_;
    std::optional<double> stamp_;
    double arrival_ = 0;
};

/// Keeps at most `capacity` items spread evenly in time over a stream whose length nobody knows: when it is full, the
/// gap between items grows and those that stand too close are dropped.
template <class Item>
class TimeSampler {
  public:
    explicit TimeSampler(int capacity) : capacity_(static_cast<std::size_t>(std::max(1, capacity))) {}

    /// Whether an item at `time` would be kept. Makes room for it. Times must not run backwards.
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
        // A hair less than twice the average, so that frames at a steady rate are not lost to rounding.
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
