#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "cli/app/job.h"
#include "cli/app/observer.h"

namespace vvr::app {

/// A clip, and the folder that its data files go to.
struct ExtractJob {
    InputOptions input;
    fields::FieldOptions fields;  ///< flow and seeds are kept every `fields.flow.every` frames
    StartTime start_time;         ///< by which `fields.span` may have been asked for
    std::filesystem::path folder;
    bool colour = false;                      ///< every frame's picture is kept too
    std::optional<std::pair<int, int>> part;  ///< the first of the second, from 1 on; none = what fields.span says
    image::Metadata settings;                 ///< all settings as texts, for the manifest
};

/// Writes the data files of Fig. 3: scalar fields, flow, seeds. An older extraction in the folder is replaced.
/// \throws Error usage, io, not_video, limit
void extract(ExtractJob job, Observer& observer);

}  // namespace vvr::app
