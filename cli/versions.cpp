#include "cli/versions.h"

#include <OpenImageIO/oiioversion.h>
#include <fmt/format.h>
#include <opencv2/core/version.hpp>

extern "C" {
#include <libavutil/ffversion.h>
}

#include "core/base/version.h"

namespace vvr::cli {

std::vector<LibraryVersion> library_versions() {
    return {{"FFmpeg", FFMPEG_VERSION}, {"OpenImageIO", OIIO_VERSION_STRING}, {"OpenCV", CV_VERSION}};
}

std::string version_text() {
    std::string text = fmt::format("vvr {}\n", version());
    for (const LibraryVersion& library : library_versions())
        text += fmt::format("{} {}\n", library.name, library.version);
    return text;
}

}  // namespace vvr::cli
