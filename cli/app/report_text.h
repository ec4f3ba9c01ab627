#pragma once

#include <string>

#include "cli/app/report.h"
#include "core/image/picture.h"

namespace vvr::app {

/// The text of a `--report` file; docs/report.md says what it means, docs/report.schema.json what may stand in it.
/// \param settings long names of options, and their texts
/// \param seconds that all of it took
std::string format_report(const RenderReport& report, const image::Metadata& settings, double seconds);

/// What a person wants to know of the events in a line: "3 events; the longest from 14.0 s to 52.5 s".
/// With times of day where they are known.
std::string summary_of(const std::vector<events::Event>& events, const WallClock& clock);

}  // namespace vvr::app
