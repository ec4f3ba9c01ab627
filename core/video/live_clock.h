#pragma once

#include <optional>

namespace vvr::video {

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

}  // namespace vvr::video
