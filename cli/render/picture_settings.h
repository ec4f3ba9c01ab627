#pragma once

#include "cli/command_line.h"
#include "cli/render/render_clip.h"
#include "core/image/picture.h"

namespace vvr {

/// The options that decided how a picture looks, by their long names.
/// \param extracted those that were decided when the fields were extracted
Metadata settings_of(const CommandLine& line, const Metadata& extracted = {});

/// The same, and what they made of this clip.
Metadata describe(const CommandLine& line, const Metadata& extracted, const RenderReport& report, bool series);

}  // namespace vvr
