#include "core/archive/clip_names.h"

#include <algorithm>

#include <fnmatch.h>

#include "core/video/video_files.h"

namespace vvr {

namespace {

std::string_view file_name(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

}  // namespace

bool ClipNames::matches(const std::string& clip) const {
    const std::string name(file_name(clip));
    if (patterns_.empty()) return is_video_name(name);
    return std::ranges::any_of(patterns_, [&](const std::string& pattern) {
        const bool whole = pattern.find('/') != std::string::npos;
        return ::fnmatch(pattern.c_str(), (whole ? clip : name).c_str(), whole ? FNM_PATHNAME : 0) == 0;
    });
}

}  // namespace vvr
