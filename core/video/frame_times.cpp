#include "core/video/frame_times.h"

#include <algorithm>

namespace vvr::video {
namespace {

constexpr double clock_was_set = 1;  // seconds

}  // namespace

double StampClock::operator()(std::optional<double> stamp) {
    if (!origin_ && stamp) origin_ = *stamp - next();
    double time = stamp ? *stamp - *origin_ : next();
    if (last_ && time < *last_ - clock_was_set) {
        time = next();
        origin_ = *stamp - time;
    }
    if (last_ && time < *last_) time = *last_;
    last_ = time;
    return time;
}

double StampClock::next() const {
    return last_ ? *last_ + duration_ : 0;
}

namespace {

// Seconds. If a timestamp advances this much more than the reader's clock, the camera has set its clock. Even a stream
// that arrives faster than real time doesn't advance as much between two frames.
constexpr double leap = 10;

}  // namespace

double LiveClock::operator()(std::optional<double> stamp, double arrival) {
    time_ = time_ ? *time_ + step(stamp, arrival) : 0;
    stamp_ = stamp;
    arrival_ = arrival;
    return *time_;
}

double LiveClock::step(const std::optional<double>& stamp, double arrival) const {
    const double passed = std::max(duration_, arrival - arrival_);
    if (!stamp) return duration_;
    if (!stamp_ || *stamp < *stamp_ || *stamp > *stamp_ + passed + leap) return passed;
    return *stamp - *stamp_;
}

}  // namespace vvr::video
