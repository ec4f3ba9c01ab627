#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace vvr::app {

/// The seconds that the stages of a run take, in the order in which they first came.
class Stages {
  public:
    /// What has passed since the last call, or since the beginning, was this stage's.
    void end(const std::string& name) {
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> took = now - std::exchange(last_, now);
        for (auto& [known, seconds] : seconds_) {
            if (known == name) {
                seconds += took.count();
                return;
            }
        }
        seconds_.emplace_back(name, took.count());
    }

    const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point last_ = Clock::now();
    std::vector<std::pair<std::string, double>> seconds_;
};

}  // namespace vvr::app
