#pragma once

#include <string>
#include <vector>

#include "cli/app/drawn.h"
#include "core/image/picture.h"

namespace vvr::app {

/// The text of a `--report` file. docs/report.md explains it; docs/report.schema.json is its schema.
/// \param advice from advice_on
/// \param seconds duration of the run
std::string format_report(const Drawn& drawn, const std::vector<std::string>& advice, double seconds);

/// The metadata of a picture's file: the settings, and their results for this clip.
image::Metadata record_of(const Drawn& drawn);

}  // namespace vvr::app
