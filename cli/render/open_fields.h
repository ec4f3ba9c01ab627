#pragma once

#include <memory>

#include "cli/render/job.h"
#include "core/fields/field_source.h"

namespace vvr {

/// The fields that a job works on.
struct OpenedFields {
    std::unique_ptr<FieldSource> source;
    Metadata extracted;  ///< settings that were decided when the fields were extracted; empty for a clip
};

/// The one clip of an input.
/// \throws Error usage unless there is exactly one
const std::string& only_input(const InputOptions& options);

/// Opens the whole of a clip.
std::unique_ptr<FrameSource> open_clip(const InputOptions& options, bool colour, int threads);

/// Opens a clip, the directory of an extraction, or several with consecutive parts.
/// \throws Error usage as well where settings contradict those of the extraction
OpenedFields open_fields(const RenderJob& job);

}  // namespace vvr
