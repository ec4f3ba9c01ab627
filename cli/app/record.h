#pragma once

#include <string>

#include "cli/app/job.h"
#include "cli/app/report.h"
#include "core/image/picture.h"

namespace vvr::app {

/// Settings with the values that were used: where a filter, a solver or a theme decided, the value that it has, as one
/// would give it on the command line. What nobody gave and nothing decided is left out.
image::Metadata used_settings(const image::Metadata& settings);

/// The settings that were used, and the font of the text where there is text: the machine's, if nobody named one.
image::Metadata settings_and_font(const RenderJob& job, const RenderReport& report);

/// What a picture's file records: the settings, and what they made of this clip.
image::Metadata record_of(const RenderJob& job, const RenderReport& report, bool series);

}  // namespace vvr::app
