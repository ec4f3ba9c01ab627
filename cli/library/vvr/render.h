#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vvr/image.h>

namespace vvr {

/// What came of a render.
struct Rendering {
    Image image;
    std::int64_t frames = 0;            ///< of the clip that the picture shows
    std::int64_t damaged = 0;           ///< packets that did not decode, and were left out
    std::vector<std::string> warnings;  ///< what a person should know of this picture: a sentence each, UTF-8
};

/// Draws one picture of a whole clip, as `vvr render` does; it writes no file and prints nothing. No config file is
/// read. It uses threads of its own, and has OpenGL on one of them, so a context of the caller stays as it is. Calls
/// must not overlap.
/// \param clip as INPUT of `vvr render`: a file, an address, a folder or pattern of pictures
/// \param settings options of `vvr render` of the groups Input to Look by their long names without dashes, values as
///        one types them: {{"size", "640x400"}, {"filter", "edges"}}; of two with the same name the last one counts
/// \throws Failure usage for a setting that there is not, or with a value that can't be; io, not_video, backend, limit
[[gnu::visibility("default")]] Rendering render_image(const std::string& clip, const Settings& settings = {});

}  // namespace vvr
