#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/compose/compose.h"
#include "cli/observe/observe.h"
#include "cli/plan/observer.h"
#include "core/image/picture.h"
#include "gl/context.h"

namespace vvr::app {

/// The duration of each stage of a run in seconds, in the order of first use.
class Stages {
  public:
    /// Adds the time since the last call, or since construction, to this stage.
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

/// The renderer and statistics of a run.
struct RunFacts {
    std::string renderer{};    ///< GL_RENDERER; empty if nothing was drawn
    std::string gl_version{};  ///< GL_VERSION
    std::string backend{};
    std::int64_t pictures = 0;    ///< so far
    bool nothing_moves = true;    ///< nothing of the volume is visible, in any picture
    bool frames_missing = false;  ///< some frames to be shown have no picture, in some picture
    Stages stages{};

    void note(const Composition& composed) {
        nothing_moves = nothing_moves && composed.nothing_moves;
        frames_missing = frames_missing || composed.frames_missing;
    }

    void describe(const gl::Context& context) {
        renderer = context.renderer();
        gl_version = context.version();
        backend = context.backend();
        stages.end("context");
    }
};

/// All facts about a run that reports and pages use.
struct RunContext {
    const Plan& plan;
    const Observation& seen;
    const Composition& composed;
    const RunFacts& run;
};

/// What only an archive asks for in a report.
struct ArchiveFacts {
    std::span<const double> tiles{};           ///< times of the contact sheet's pictures, seconds
    std::string not_kept{};                    ///< which events have no piece, and why; empty = all have one
    std::optional<ErrorCode> not_kept_code{};  ///< if a file could not be read or written
};

/// The text of a `--report` file. docs/report.md explains it; docs/report.schema.json is its schema.
/// \param advice from advice_on
/// \param seconds duration of the run
std::string format_report(const RunContext& context, const std::vector<std::string>& advice, double seconds,
                          const ArchiveFacts& archive = {});

/// The metadata of a picture's file: the settings, and their results for this clip.
image::Metadata record_of(const RunContext& context);

// Texts for people about a run.
/// The result of a run in one line.
std::string result_text(const RunContext& context);

/// A summary of the events in one line: "3 events; the longest from 14.0 s to 52.5 s". Uses wall-clock times if known.
std::string events_summary(const std::vector<tracking::Event>& events, std::size_t not_chosen, const WallClock& clock);

/// Suggestions for this clip, one sentence each.
std::vector<std::string> advice_on(const Plan& plan, const Observation& seen);

/// Logs all possible problems of the input or the picture.
/// \param advice from advice_on
void log_warnings(const RunContext& context, const std::vector<std::string>& advice, Observer& observer);

}  // namespace vvr::app
