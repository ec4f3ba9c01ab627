#pragma once

#include <optional>
#include <string>

#include "cli/app/job.h"
#include "cli/app/report.h"
#include "core/page/page.h"

namespace vvr::app {

/// The text of a page of one picture.
/// \param settings of the picture
/// \param live of a stream
std::string page_text(const RenderJob& job, const RenderReport& report, image::Picture picture,
                      const image::Metadata& settings, page::Moments moments,
                      const std::optional<page::LiveState>& live = {});

}  // namespace vvr::app
