#include "cli/versions.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/version.hpp>

extern "C" {
#include <libavutil/avutil.h>
}

#include "core/version.h"

namespace vvr {

std::vector<LibraryVersion> library_versions() {
    const int oiio = OIIO::openimageio_version();
    return {
        {"FFmpeg", av_version_info()},
        {"OpenImageIO", fmt::format("{}.{}.{}", oiio / 10000, oiio / 100 % 100, oiio % 100)},
        {"OpenCV", cv::getVersionString()},
    };
}

std::string version_text() {
    std::string text = fmt::format("vvr {}\n", version());
    for (const LibraryVersion& library : library_versions())
        text += fmt::format("{} {}\n", library.name, library.version);
    return text;
}

}  // namespace vvr
