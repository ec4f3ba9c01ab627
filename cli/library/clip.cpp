#include <memory>
#include <vector>

#include <vvr/clip.h>

#include "cli/app/input.h"
#include "cli/library/as_failure.h"
#include "core/video/frame_source.h"

namespace vvr {

ClipInfo read_clip_info(const std::string& clip) {
    return as_failure([&] {
        app::InputOptions input;
        input.names = {clip};
        app::require_input(input);
        std::vector<std::string> warnings;
        const std::unique_ptr<video::FrameSource> source = app::open_clip(input, false, 0, warnings);
        const video::VideoInfo& info = source->info();
        return ClipInfo{info.container, info.codec,    info.size.width, info.size.height,
                        info.rate,      info.duration, info.frames};
    });
}

}  // namespace vvr
