#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/app/job.h"
#include "core/base/wall_clock.h"
#include "core/bricks/brick.h"
#include "core/bricks/volume.h"
#include "core/events/event.h"
#include "core/image/picture.h"
#include "core/labels/lettering.h"
#include "core/video/frame_source.h"

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

/// What came of a run. It is only written while the run lasts: nothing is drawn from it.
struct RenderReport {
    video::VideoInfo info;
    Size field_size;
    std::int64_t frames = 0;  ///< that reached the volume
    std::int64_t damaged = 0;
    std::vector<std::string> problems;  ///< of files of the input, a sentence each
    double first_pts = 0;               ///< seconds
    double last_pts = 0;
    std::int64_t first_frame = 0;  ///< index in the clip
    std::int64_t last_frame = 0;
    WallClock clock;  ///< that the picture shows
    std::int64_t layers = 0;
    std::int64_t step = 1;                         ///< frames per layer
    std::vector<bricks::Brick> bricks;             ///< in layers
    std::vector<bricks::CompressedIdle> squeezed;  ///< where time has less room than in the mean
    std::int64_t pictures = 1;                     ///< so far
    std::size_t arrows = 0;
    bool still = false;           ///< nothing in the volume is visible
    bool frames_missing = false;  ///< some of the frames to be shown came without a picture
    std::string renderer;         ///< GL_RENDERER
    std::string gl_version;       ///< GL_VERSION
    std::string backend;
    std::optional<std::vector<events::Event>> events;  ///< none where they were not looked for
    std::vector<std::size_t> event_numbers;  ///< that the picture shows; empty = their places in the list, plus 1
    std::vector<std::string> advice;         ///< what would serve this clip better, in sentences
    std::vector<glm::vec3> event_colours;    ///< in the picture, sRGB; empty where they have none
    std::vector<Plane<Bgr>> portraits;       ///< of the events, small; empty where nobody asked for them
    labels::Lettering lettering;             ///< on the last picture
    std::size_t keyframes = 0;               ///< shown between the first and the last frame
    Stages stages;
};

/// The text of a `--report` file; docs/report.md says what it means, docs/report.schema.json what may stand in it.
/// \param settings long names of options, and their texts
/// \param seconds that all of it took
std::string format_report(const RenderReport& report, const image::Metadata& settings, double seconds);

/// What a person wants to know of the events in a line: "3 events; the longest from 14.0 s to 52.5 s".
/// With times of day where they are known.
std::string summary_of(const std::vector<events::Event>& events, const WallClock& clock);

/// What would serve this clip better, each in a sentence for people.
std::vector<std::string> advice_on(const RenderJob& job, const RenderReport& report);

}  // namespace vvr::app
