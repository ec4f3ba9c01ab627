#include "cli/app/find_frame.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/words.h"

namespace vvr::app {

Moment find_frame(video::FrameSource& clip, const Time& time) {
    const bool by_number = time.unit == Time::Unit::frames;
    Moment found;
    double before = 0;
    bool past = false;
    while (const auto frame = clip.next()) {
        past = frame->index > 0 && (by_number ? static_cast<double>(frame->index) : frame->pts) > time.value;
        if (past) break;
        before = found.seconds;
        found = {frame->index, frame->pts};
    }
    clip.rewind();
    // The last frame is on show for as long as the one before it was.
    const double end = found.seconds + (found.seconds - before);
    const bool shown =
        by_number ? time.value <= static_cast<double>(found.frame) : time.value <= found.seconds || time.value < end;
    if (past || shown) return found;
    throw Error(ErrorKind::usage,
                fmt::format("frame: '{}' has {}, the last at {:.3f} s; choose an earlier one", clip.info().name,
                            counted(found.frame + 1, "frame"), found.seconds),
                {"frame"});
}

}  // namespace vvr::app
