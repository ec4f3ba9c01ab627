#include "core/video/video_files.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "core/base/ending.h"
#include "core/base/error.h"

namespace vvr::video {

namespace fs = std::filesystem;

const std::vector<std::string>& video_extensions() {
    static const std::vector<std::string> endings{
        ".264", ".265", ".3gp",  ".asf", ".avi",   ".dav",  ".divx", ".dv",   ".flv", ".h264", ".h265", ".hevc",
        ".ivf", ".m2t", ".m2ts", ".m4v", ".mjpeg", ".mjpg", ".mkv",  ".mov",  ".mp4", ".mpeg", ".mpg",  ".mts",
        ".mxf", ".nut", ".ogm",  ".ogv", ".rm",    ".ts",   ".vob",  ".webm", ".wmv", ".y4m"};
    return endings;
}

bool is_video_name(const std::string& name) {
    return std::ranges::binary_search(video_extensions(), extension_of(name));
}

std::vector<std::string> video_files_in(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code why;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, why);
         !why && entry != fs::recursive_directory_iterator(); entry.increment(why)) {
        const std::string name = entry->path().filename().string();
        std::error_code none;
        if (name.starts_with('.')) {
            entry.disable_recursion_pending();
        } else if (is_video_name(name) && entry->is_regular_file(none)) {
            files.push_back(entry->path().string());
        }
    }
    if (why) {
        throw Error(ErrorKind::io, fmt::format("cannot read the folder '{}': {}; check its permissions",
                                               folder.string(), why.message()));
    }
    return files;
}

}  // namespace vvr::video
