#include "core/archive/clip_names.h"

#include <algorithm>

#include <fnmatch.h>

#include "core/ending.h"

namespace vvr {

namespace {

std::string_view file_name(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

}  // namespace

const std::vector<std::string>& video_endings() {
    static const std::vector<std::string> endings{
        ".264", ".265", ".3gp",  ".asf", ".avi",   ".dav",  ".divx", ".dv",   ".flv", ".h264", ".h265", ".hevc",
        ".ivf", ".m2t", ".m2ts", ".m4v", ".mjpeg", ".mjpg", ".mkv",  ".mov",  ".mp4", ".mpeg", ".mpg",  ".mts",
        ".mxf", ".nut", ".ogm",  ".ogv", ".rm",    ".ts",   ".vob",  ".webm", ".wmv", ".y4m"};
    return endings;
}

bool ClipNames::matches(const std::string& clip) const {
    const std::string name(file_name(clip));
    if (patterns_.empty()) return std::ranges::binary_search(video_endings(), ending_of(name));
    return std::ranges::any_of(patterns_, [&](const std::string& pattern) {
        const bool whole = pattern.find('/') != std::string::npos;
        return ::fnmatch(pattern.c_str(), (whole ? clip : name).c_str(), whole ? FNM_PATHNAME : 0) == 0;
    });
}

}  // namespace vvr
