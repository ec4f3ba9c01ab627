#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vvr/image.h>

namespace vvr {

/// The result of a render.
struct Rendering {
    Image image;
    std::int64_t frames = 0;            ///< frames of the clip that the picture shows
    std::int64_t damaged = 0;           ///< packets skipped because they did not decode
    std::vector<std::string> warnings;  ///< about this picture, for people; UTF-8, one sentence each
};

/// Draws one picture of a whole clip, as `vvr render` does. Writes no file, prints nothing, and reads no config file.
/// It starts its own threads and uses OpenGL on one of them only, so the caller's context is unaffected. Calls must not
/// overlap.
/// \param clip as INPUT of `vvr render`: a file, a URL, a folder or pattern of pictures
/// \param settings options of `vvr render` in its groups Input to Look: long names without dashes, and values as text,
/// such as {{"size", "640x400"}, {"filter", "edges"}}; the last of equal names wins
/// \throws Failure usage for an unknown setting or an invalid value; io, not_video, backend, limit
[[gnu::visibility("default")]] Rendering render_image(const std::string& clip, const Settings& settings = {});

}  // namespace vvr
