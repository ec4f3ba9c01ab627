#include "core/archive/clip_names.h"

#include <algorithm>

#include <fnmatch.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/video/video_files.h"

namespace vvr::archive {

namespace {

std::string_view file_name(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

bool fits(const std::string& pattern, const std::string& clip) {
    const bool whole = pattern.find('/') != std::string::npos;
    return ::fnmatch(pattern.c_str(), (whole ? clip : std::string(file_name(clip))).c_str(),
                     whole ? FNM_PATHNAME : 0) == 0;
}

}  // namespace

bool ClipNames::matches(const std::string& clip) const {
    const auto fits_clip = [&](const std::string& pattern) { return fits(pattern, clip); };
    if (std::ranges::any_of(excluded_, fits_clip)) return false;
    if (videos_ && video::is_video_name(std::string(file_name(clip)))) return true;
    return std::ranges::any_of(patterns_, fits_clip);
}

ClipNames ClipNames::with_all() const {
    ClipNames all(patterns_);
    all.videos_ = true;
    return all;
}

std::string ClipNames::wanted() const {
    std::string names;
    if (videos_) names = fmt::format("{}", fmt::join(video::video_extensions(), " "));
    return patterns_.empty() ? names : fmt::format("{}", fmt::join(patterns_, " "));
}

}  // namespace vvr::archive
