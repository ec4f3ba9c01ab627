#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace vvr::bench {

/// One of the things that are compared.
struct Work {
    std::function<void()> prepare;  ///< not timed
    std::function<void()> run;
};

/// Runs all works in turn, `runs` times after a first that isn't counted, so that what else the machine does meets all
/// of them alike.
/// \returns the seconds of every run, by work
inline std::vector<std::vector<double>> in_turn(const std::vector<Work>& works, int runs) {
    std::vector<std::vector<double>> seconds(works.size());
    for (int i = 0; i <= runs; ++i) {
        for (std::size_t w = 0; w < works.size(); ++w) {
            if (works[w].prepare) works[w].prepare();
            const auto begin = std::chrono::steady_clock::now();
            works[w].run();
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
            if (i > 0) seconds[w].push_back(took.count());
        }
    }
    return seconds;
}

inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

}  // namespace vvr::bench
