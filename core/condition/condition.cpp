#include "core/condition/condition.h"

#include <algorithm>

namespace vvr::condition {

std::vector<Interval> joined(std::vector<Interval> intervals) {
    constexpr double at_once = 0.5;  // seconds
    std::ranges::stable_sort(intervals, {}, &Interval::begin);
    std::vector<Interval> result;
    for (const Interval& interval : intervals) {
        const bool goes_on =
            !result.empty() && result.back().kind == interval.kind && interval.begin - result.back().end < at_once;
        if (goes_on) {
            result.back().end = std::max(result.back().end, interval.end);
        } else {
            result.push_back(interval);
        }
    }
    return result;
}

void lengthen(std::vector<Interval>& intervals, const Interval& more) {
    const double half = (more.end - more.begin) / 2;
    if (!intervals.empty() && more.begin <= intervals.back().end + half) {
        intervals.back().end = more.end;
    } else {
        intervals.push_back(more);
    }
}

}  // namespace vvr::condition
