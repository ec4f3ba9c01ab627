#pragma once

#include <filesystem>

#include "cli/render/job.h"
#include "cli/render/observer.h"

namespace vvr {

/// One frame of a clip, and where the picture of its fields goes.
struct InspectJob {
    InputOptions input;
    FieldOptions fields;
    Time frame;
    std::filesystem::path path;
};

/// Draws Fig. 4 for a frame: its difference object, flow and seeds side by side.
/// \throws Error usage, io, not_video, limit
void inspect(const InspectJob& job, Observer& observer);

}  // namespace vvr
