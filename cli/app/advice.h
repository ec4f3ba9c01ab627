#pragma once

#include <string>
#include <vector>

#include "cli/app/job.h"
#include "cli/app/report.h"

namespace vvr::app {

/// What would serve this clip better, each in a sentence for people.
std::vector<std::string> advice_on(const RenderJob& job, const RenderReport& report);

}  // namespace vvr::app
