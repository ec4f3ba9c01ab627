#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "core/condition/condition.h"
#include "core/media/av.h"

namespace vvr::media {

/// As many frames a tick apart are no accident.
inline constexpr int lasting_ticks = 25;

/// Whether two frames are so close that no camera can have seen them so.
/// \param step between them, seconds
/// \param usual distance of frames, seconds
constexpr bool is_tick(double step, double usual) {
    constexpr double shortest = 0.003;  // seconds
    constexpr double share = 0.1;
    return step >= 0 && step < shortest && step < share * usual;
}

/// Frames whose timestamps were mended.
struct MendedFrames {
    std::int64_t frames = 0;
    double from = 0;                               ///< mended time of the first one on the container's clock, seconds
    std::vector<condition::Interval> intervals{};  ///< all of them, by their mended times
};

/// Mends timestamps that lie almost no time apart for many frames. Recorders write such ones when a camera's clock goes
/// back, until it has caught up, and when a network delivers frames late and all at once. These frames get the usual
/// distance: in the gap before them as far as there is one, else later times move too.
class StampMender {
  public:
    using Read = std::function<bool(AVPacket&)>;

    /// \param stream index of the stream that is mended
    /// \param tick of its timestamps, seconds
    /// \param usual ticks between its frames, as the container states
    StampMender(int stream, double tick, double usual) : stream_(stream), tick_(tick), usual_(usual) {}

    /// The next packet of any stream. False at the end.
    /// \param next reads a packet as it is
    bool read(AVPacket& packet, const Read& next);

    const MendedFrames& mended() const { return mended_; }

  private:
    struct Stamps {
        std::int64_t dts = 0;
        std::int64_t pts = 0;
    };

    bool is_timed(const AVPacket& packet) const;
    bool are_tick_apart(const Stamps& before, const Stamps& now) const;
    bool begins_run(Stamps before, const Read& next);
    void mend(AVPacket& packet, const Read& next);

    int stream_;
    double tick_;
    double usual_;
    std::optional<Stamps> last_;  ///< of the packet before, unmended
    double offset_ = 0;           ///< ticks
    bool in_run_ = false;
    std::deque<av::Ptr<AVPacket>> ahead_;  ///< read, not yet returned
    std::size_t no_run_ = 0;               ///< of these, packets of which it is known that no run begins there
    MendedFrames mended_;
};

}  // namespace vvr::media
