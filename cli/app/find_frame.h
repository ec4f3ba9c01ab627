#pragma once

#include "cli/app/time.h"
#include "core/base/moment.h"
#include "core/video/frame_source.h"

namespace vvr::app {

/// The frame of that number, or the one shown at that time. Counts the frames that decode, from the first on, whatever
/// the container says. Leaves the clip at its first frame.
/// \throws Error usage that says how long the clip is, where it ends before
Moment find_frame(video::FrameSource& clip, const Time& time);

}  // namespace vvr::app
