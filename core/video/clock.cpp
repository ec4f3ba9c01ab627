#include "core/video/clock.h"

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

}  // namespace vvr::video
