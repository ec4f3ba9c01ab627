#pragma once

#include <string>

#include "cli/app/drawn.h"
#include "core/image/picture.h"

namespace vvr::app {

/// The text of a `--report` file. docs/report.md explains it; docs/report.schema.json is its schema.
/// \param seconds duration of the run
std::string format_report(const Drawn& drawn, double seconds);

/// The metadata of a picture's file: the settings, and their results for this clip.
image::Metadata record_of(const Drawn& drawn);

}  // namespace vvr::app
