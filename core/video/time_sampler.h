#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace vvr::video {

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
