#include "core/archive/clip_names.h"

#include <algorithm>
#include <cctype>

#include <fnmatch.h>

namespace vvr {

namespace {

std::string_view file_name(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

std::string lower(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
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
    if (patterns_.empty()) {
        const auto dot = name.rfind('.');
        return dot != std::string::npos && dot > 0 &&
               std::ranges::binary_search(video_endings(), lower(std::string_view(name).substr(dot)));
    }
    return std::ranges::any_of(patterns_, [&](const std::string& pattern) {
        const bool whole = pattern.find('/') != std::string::npos;
        return ::fnmatch(pattern.c_str(), (whole ? clip : name).c_str(), whole ? FNM_PATHNAME : 0) == 0;
    });
}

}  // namespace vvr
