#pragma once

#include <string>
#include <vector>

#include "cli/app/job.h"
#include "core/video/recording.h"

namespace vvr::app {

/// The files of an input in order, each with its camera, start time, and the source of that time. Empty for inputs
/// without them, such as a stream or pictures.
std::vector<video::Segment> list_clips(const InputOptions& options);

/// "camera gate, 2026-11-21 20:00:00 UTC by file name (Frigate)"
std::string text_of(const video::Segment& clip);

}  // namespace vvr::app
