#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/app/stages.h"
#include "core/base/wall_clock.h"
#include "core/bricks/brick.h"
#include "core/bricks/volume.h"
#include "core/events/event.h"
#include "core/labels/lettering.h"
#include "core/video/frame_source.h"

namespace vvr::app {

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
    std::int64_t step = 1;                   ///< frames per layer
    std::vector<bricks::Brick> bricks;       ///< in layers
    std::vector<bricks::CompressedIdle> squeezed;  ///< where time has less room than in the mean
    std::int64_t pictures = 1;               ///< so far
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

}  // namespace vvr::app
