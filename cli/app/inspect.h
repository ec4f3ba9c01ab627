#pragma once

#include <filesystem>
#include <optional>

#include "cli/app/job.h"
#include "cli/app/observer.h"

namespace vvr::app {

/// One frame of a clip, and the output: a picture of its fields, or a page for drawing regions.
struct InspectJob {
    InputOptions input;
    fields::FieldOptions fields;
    std::optional<Time> frame;  ///< none = the middle of the clip, but at most a minute into it
    std::filesystem::path path;
    std::filesystem::path font;  ///< for captions; empty = fontconfig's sans
};

/// Draws Fig. 4 for a frame: its difference object, flow and seeds side by side. A page gets only the frame, for
/// drawing regions on it, and starts with the regions of `fields`.
/// \throws Error usage, io, not_video, limit
void inspect(const InspectJob& job, Observer& observer);

}  // namespace vvr::app
