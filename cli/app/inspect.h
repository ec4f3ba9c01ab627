#pragma once

#include <filesystem>
#include <optional>

#include "cli/app/job.h"
#include "cli/app/observer.h"

namespace vvr::app {

/// One frame of a clip, and where the picture of its fields goes, or the page on which regions are drawn.
struct InspectJob {
    InputOptions input;
    fields::FieldOptions fields;
    std::optional<Time> frame;  ///< none = the middle of the clip, but not far into it
    std::filesystem::path path;
    std::filesystem::path font;  ///< of the captions; empty = fontconfig's sans
};

/// Draws Fig. 4 for a frame: its difference object, flow and seeds side by side. Into a page goes the frame alone, to
/// draw regions on; it begins with those that the fields have.
/// \throws Error usage, io, not_video, limit
void inspect(const InspectJob& job, Observer& observer);

}  // namespace vvr::app
