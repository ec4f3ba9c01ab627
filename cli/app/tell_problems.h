#pragma once

#include <string>
#include <vector>

#include "cli/app/observer.h"
#include "core/video/frame_source.h"

namespace vvr::app {

/// Warns of what was wrong with an input: all warnings, and some of the files' problems.
void report_warnings(const std::vector<std::string>& warnings, const std::vector<std::string>& problems,
                   Observer& observer);

/// \throws Error partial when some files of a recording were left out whole: all else is done by then
void require_whole(const video::VideoInfo& info);

}  // namespace vvr::app
