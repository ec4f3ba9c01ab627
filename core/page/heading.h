#pragma once

#include <string>

#include "core/base/wall_clock.h"

namespace vvr::page {

/// Whose page it is: "back-door · Tue 17 Nov 2026, 07:15", with the minute of the end if that is another. Where the
/// time of day is not known, the name alone. \param name of the camera, or of the clip where that is not known \param
/// begin, end seconds of the clip
std::string heading_of(const std::string& name, const WallClock& clock, double begin, double end);

}  // namespace vvr::page
