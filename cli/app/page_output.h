#pragma once

#include <optional>
#include <string>

#include "cli/app/job.h"
#include "cli/app/report.h"
#include "core/page/page.h"

namespace vvr {

/// The text of a page of one picture.
/// \param settings of the picture
/// \param live of a stream
std::string page_text(const RenderJob& job, const RenderReport& report, Picture picture, const Metadata& settings,
                      Moments moments, const std::optional<LiveState>& live = {});

}  // namespace vvr
