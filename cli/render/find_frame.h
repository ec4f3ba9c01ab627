#pragma once

#include <cstdint>

#include "cli/render/time.h"
#include "core/video/frame_source.h"

namespace vvr {

/// Where a time falls in a clip.
struct FoundFrame {
    std::int64_t index = 0;
    double pts = 0;        ///< seconds
    bool is_there = true;  ///< false = the clip ends before; then the last frame
};

/// The frame of that number, or the one shown at that time. Counts the frames that decode, from the first
/// on, whatever the container says. Leaves the clip at its first frame.
FoundFrame find_frame(FrameSource& clip, const Time& time);

/// The frame at a time that has to be in the clip.
/// \throws Error usage that says how long the clip is
FoundFrame frame_at(FrameSource& clip, const Time& time);

}  // namespace vvr
