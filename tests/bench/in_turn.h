#pragma once

#include <chrono>
#include <functional>
#include <vector>

namespace vvr::bench {

/// Runs all works in turn, `runs` times after a first that isn't counted, so that what else the machine does meets all
/// of them alike.
/// \returns the seconds of every run, by work
inline std::vector<std::vector<double>> in_turn(const std::vector<std::function<void()>>& works, int runs) {
    std::vector<std::vector<double>> seconds(works.size());
    for (int i = 0; i <= runs; ++i) {
        for (std::size_t w = 0; w < works.size(); ++w) {
            const auto begin = std::chrono::steady_clock::now();
            works[w]();
            const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
            if (i > 0) seconds[w].push_back(took.count());
        }
    }
    return seconds;
}

}  // namespace vvr::bench
