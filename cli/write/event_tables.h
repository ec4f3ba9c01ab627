#pragma once

#include <string>

#include "cli/write/report.h"

// The events of a clip as a table, for tools that evaluate trackers.
namespace vvr::app {

/// The text of a `--tracks` file in the format of MOT Challenge: frame, number of the event, left, top, width, height,
/// 1, -1, -1, -1. Frames and places count from 1; places are in pixels of the video.
std::string tracks_table(const RunContext& context);

}  // namespace vvr::app
