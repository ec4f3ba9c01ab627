#pragma once

#include <optional>

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

}  // namespace vvr::video
