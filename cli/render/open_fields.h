#pragma once

#include <memory>
#include <string_view>

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

/// The same fields with the seeds that the job lists, if it does.
/// \param filter of the fields
std::unique_ptr<FieldSource> with_listed_seeds(std::unique_ptr<FieldSource> fields, const RenderJob& job,
                                               std::string_view filter);

/// Opens a clip, the directory of an extraction, or several with consecutive parts.
/// \throws Error usage as well where settings contradict those of the extraction
OpenedFields open_fields(const RenderJob& job);

}  // namespace vvr
