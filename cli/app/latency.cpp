#include "cli/app/latency.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace vvr::app {

void Latency::add(double seconds) {
    last_.push_back(seconds);
    if (last_.size() > kept) last_.pop_front();
}

double Latency::median() const {
    if (last_.empty()) return 0;
    std::vector<double> sorted(last_.begin(), last_.end());
    const auto middle = sorted.begin() + std::ssize(sorted) / 2;
    std::ranges::nth_element(sorted, middle);
    return *middle;
}

double Latency::longest() const {
    return last_.empty() ? 0 : std::ranges::max(last_);
}

}  // namespace vvr::app
