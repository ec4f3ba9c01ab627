#pragma once

#include <string>
#include <string_view>

#include "cli/render/job.h"
#include "cli/render/report.h"

namespace vvr {

/// Sets a value, in place of the one that there may be under its name.
void put(Metadata& settings, std::string_view name, const std::string& value);

/// What a picture's file records: the settings, and what they made of this clip.
Metadata record_of(const RenderJob& job, const RenderReport& report, bool series);

}  // namespace vvr
