#pragma once

#include <cstdint>
#include <vector>

namespace vvr::page {

/// Consecutive frames at a steady rate.
struct ConstantRateFrames {
    std::int64_t first = 0;  ///< index in the clip
    std::int64_t count = 1;
    double begin = 0;  ///< seconds, of the first
    double step = 0;   ///< seconds from each to the next; 0 where there is only one

    double at(std::int64_t frame) const { return begin + static_cast<double>(frame - first) * step; }
};

/// The times of a clip's frames in few numbers: a clip at a steady rate is one stretch, of any length and with any
/// rounding by its container. Memory grows only with the changes of the rate.
class Timeline {
  public:
    /// The greatest error of a frame's time, in seconds: less than the shortest time that a screen shows a frame.
    static constexpr double tolerance = 0.001;

    /// \param frame greater than the one before; so is its time in most clips
    void add(std::int64_t frame, double seconds);

    std::vector<ConstantRateFrames> stretches() const;

    std::int64_t frames() const { return frames_; }

  private:
    void begin(std::int64_t frame, double seconds);
    ConstantRateFrames current() const;

    std::vector<ConstantRateFrames> done_;
    std::int64_t frames_ = 0;
    std::int64_t first_ = 0;
    std::int64_t count_ = 0;
    double begin_ = 0;
    double least_ = 0;  ///< any step from this to `most_` keeps all frames of the stretch within the tolerance
    double most_ = 0;
};

}  // namespace vvr::page
