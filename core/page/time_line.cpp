#include "core/page/time_line.h"

#include <algorithm>
#include <limits>

namespace vvr::page {

void Timeline::add(std::int64_t frame, double seconds) {
    ++frames_;
    if (count_ == 0 || frame != first_ + count_) {
        begin(frame, seconds);
        return;
    }
    const auto steps = static_cast<double>(count_);
    const double least = std::max(least_, (seconds - tolerance - begin_) / steps);
    const double most = std::min(most_, (seconds + tolerance - begin_) / steps);
    if (least > most) {
        begin(frame, seconds);
        return;
    }
    least_ = least;
    most_ = most;
    ++count_;
}

std::vector<ConstantRateFrames> Timeline::stretches() const {
    std::vector<ConstantRateFrames> all = done_;
    if (count_ > 0) all.push_back(current());
    return all;
}

void Timeline::begin(std::int64_t frame, double seconds) {
    if (count_ > 0) done_.push_back(current());
    first_ = frame;
    count_ = 1;
    begin_ = seconds;
    least_ = 0;
    most_ = std::numeric_limits<double>::infinity();
}

ConstantRateFrames Timeline::current() const {
    return {first_, count_, begin_, count_ > 1 ? (least_ + most_) / 2 : 0};
}

}  // namespace vvr::page
