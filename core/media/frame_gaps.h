#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace vvr::media {

/// A stretch in which frames are missing.
struct FrameGap {
    double begin = 0;         ///< time of the last frame before it, seconds
    double end = 0;           ///< time of the first frame after it
    std::int64_t frames = 0;  ///< that are missing, by the interval of the frames before
    bool numbered = false;    ///< whether numbers of frames are left out for it, as `FrameNumbers` does
};

/// Finds gaps of any length in the times of frames. FrameNumbers knows only the long ones.
class FrameGaps {
  public:
    /// \param rate usual frames per second; 0 = unknown
    /// \param irregular frames come at any times, so only those whose numbers are left out are missing
    explicit FrameGaps(double rate = 0, bool irregular = false)
        : usual_(rate > 0 ? 1 / rate : 0), irregular_(irregular) {}

    /// \param time of the next frame, seconds; must not decrease
    /// \param skips whether numbers are left out before it
    /// \returns the gap before that frame
    std::optional<FrameGap> operator()(double time, bool skips = false) {
        constexpr double unusual = 2.5;  // intervals
        const double last = std::exchange(last_, time);
        const double apart = std::exchange(begun_, true) ? time - last : 0;
        const double interval = 2 * interval_ > usual_ ? interval_ : usual_;
        const bool is_long = !irregular_ && apart >= unusual * std::max(interval, usual_);
        const bool is_gap = interval > 0 && apart > 0 && (skips || is_long);
        // A camera that slows down has a gap only at first.
        const bool keeps = std::exchange(was_gap_, is_gap) ? false : is_gap;
        if (apart > 0 && !keeps) interval_ = apart;
        if (!is_gap) return std::nullopt;
        return FrameGap{last, time, std::max<std::int64_t>(1, std::llround(apart / interval) - 1), skips};
    }

  private:
    double usual_;  ///< interval, seconds; 0 = unknown
    bool irregular_;
    double interval_ = 0;  ///< of the two frames before, seconds
    double last_ = 0;      ///< seconds
    bool begun_ = false;
    bool was_gap_ = false;
};

/// Packets that could not be read or decoded.
struct Damage {
    double begin = 0;  ///< time of the frame before them, seconds
    double end = 0;    ///< time of the frame after them
    std::int64_t packets = 0;
};

/// Adds damage to that just before it, so that a bad disk makes no endless list.
inline void add_damage(std::vector<Damage>& list, const Damage& more) {
    constexpr double near = 1;  // seconds
    constexpr std::size_t most = 1000;
    if (list.empty() || (more.begin - list.back().end > near && list.size() < most)) {
        list.push_back(more);
        return;
    }
    list.back().end = more.end;
    list.back().packets += more.packets;
}

}  // namespace vvr::media
