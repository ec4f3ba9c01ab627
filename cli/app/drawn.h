#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/app/composition.h"
#include "cli/app/observe.h"
#include "core/image/picture.h"
#include "gl/context.h"

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

/// What drew, and how it went.
struct RunFacts {
    std::string renderer{};    ///< GL_RENDERER
    std::string gl_version{};  ///< GL_VERSION
    std::string backend{};
    std::int64_t pictures = 0;  ///< so far
    Stages stages{};

    void describe(const gl::Context& context) {
        renderer = context.renderer();
        gl_version = context.version();
        backend = context.backend();
        stages.end("context");
    }
};

/// What was seen and drawn, for those who tell of it.
struct Drawn {
    const Plan& plan;
    const Observation& seen;
    const Composition& composed;
    const RunFacts& run;
};

/// A picture on its way to its files.
struct FinishedPicture {
    int number = 0;  ///< from 0 on; in a series that of its brick
    image::Picture picture;
    Drawn drawn;
};

/// Takes each picture of a run, in order.
using PictureSink = std::function<void(FinishedPicture&&)>;

/// What came of a run.
struct Outcome {
    Observation seen;
    Composition composed;  ///< of the last picture
    RunFacts run;
};

}  // namespace vvr::app
