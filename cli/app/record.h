#pragma once

#include <string>
#include <string_view>

#include "cli/app/job.h"
#include "cli/app/report.h"

namespace vvr::app {

/// Sets a value, in place of the one that has its name.
void put(image::Metadata& settings, std::string_view name, const std::string& value);

/// The value of that name; empty where there is none.
std::string value_of(const image::Metadata& settings, std::string_view name);

/// The settings that were used, and the font of the text where there is text: the machine's, if nobody named one.
image::Metadata settings_and_font(const RenderJob& job, const RenderReport& report);

/// What a picture's file records: the settings, and what they made of this clip.
image::Metadata record_of(const RenderJob& job, const RenderReport& report, bool series);

}  // namespace vvr::app
