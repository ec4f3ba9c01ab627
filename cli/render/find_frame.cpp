#include "cli/render/find_frame.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/words.h"

namespace vvr {

FoundFrame find_frame(FrameSource& clip, const Time& time) {
    const bool by_number = time.unit == Time::Unit::frames;
    FoundFrame found;
    double before = 0;
    while (const auto frame = clip.next()) {
        const bool past = by_number ? static_cast<double>(frame->index) > time.value : frame->pts > time.value;
        if (past && frame->index > 0) {
            clip.rewind();
            return found;
        }
        before = found.pts;
        found = {frame->index, frame->pts, true};
    }
    clip.rewind();
    // The last frame is on show for as long as the one before it was.
    const double end = found.pts + (found.pts - before);
    found.is_there =
        by_number ? time.value <= static_cast<double>(found.index) : time.value <= found.pts || time.value < end;
    return found;
}

FoundFrame frame_at(FrameSource& clip, const Time& time) {
    const FoundFrame found = find_frame(clip, time);
    if (found.is_there) return found;
    throw Error(ErrorKind::usage,
                fmt::format("frame: '{}' has {}, the last at {:.3f} s; choose an earlier one", clip.info().name,
                            counted(found.index + 1, "frame"), found.pts),
                {"frame"});
}

}  // namespace vvr
