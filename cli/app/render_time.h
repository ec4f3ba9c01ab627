#pragma once

#include <cstdint>

#include "cli/plan/job.h"
#include "cli/plan/plan.h"

namespace vvr::app {

/// How long a render takes on this machine, as measured on the first seconds of the clip.
struct RenderTime {
    double frames_per_second = 0;  ///< read, with fields and events
    double seconds = 0;            ///< of the whole picture, without a page; 0 = the clip's length is unknown
    std::int64_t measured = 0;     ///< frames that were read for this
};

/// Draws a picture of the first seconds of a clip, and writes it nowhere.
/// \param plan of the whole clip
/// \throws Error of every kind
RenderTime measure_render(const RenderJob& job, const Plan& plan);

}  // namespace vvr::app
