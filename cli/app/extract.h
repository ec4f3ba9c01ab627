#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "cli/app/job.h"
#include "cli/app/observer.h"

namespace vvr::app {

/// A clip, and the folder for its data files.
struct ExtractJob {
    InputOptions input;
    fields::FieldOptions fields;  ///< flow and seeds are stored every `fields.flow.every` frames
    StartTime start_time;         ///< for a `fields.span` given in wall-clock times
    std::filesystem::path folder;
    bool colour = false;                      ///< store every frame's picture too
    std::optional<std::pair<int, int>> part;  ///< part I of N as {I, N}, from 1; none = use fields.span
    image::Metadata settings;                 ///< all settings as text, for the manifest
};

/// Writes the data files of Fig. 3: scalar fields, flow, seeds. Replaces an older extraction in the folder.
/// \throws Error usage, io, not_video, limit
void extract(ExtractJob job, Observer& observer);

}  // namespace vvr::app
