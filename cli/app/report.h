#pragma once

#include <string>

#include "cli/app/drawn.h"
#include "core/image/picture.h"

namespace vvr::app {

/// The text of a `--report` file; docs/report.md says what it means, docs/report.schema.json what may stand in it.
/// \param seconds that all of it took
std::string format_report(const Drawn& drawn, double seconds);

/// What a picture's file records: the settings, and what they made of this clip.
image::Metadata record_of(const Drawn& drawn);

}  // namespace vvr::app
