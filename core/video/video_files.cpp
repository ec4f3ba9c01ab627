#include "core/video/video_files.h"

#include <algorithm>
#include <array>
#include <memory>
#include <system_error>

#include <glob.h>
#include <sys/stat.h>

#include <climits>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"

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

bool is_picture_name(const std::string& name) {
    static constexpr std::array<std::string_view, 19> picture_extensions{
        ".bmp", ".dpx", ".exr", ".gif", ".jp2", ".jpe", ".jpeg", ".jpg",  ".pam", ".pbm",
        ".pgm", ".png", ".pnm", ".ppm", ".sgi", ".tga", ".tif",  ".tiff", ".webp"};
    return std::ranges::binary_search(picture_extensions, extension_of(name));
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
        throw Error(
            code_of_system_error(why.value()),
            fmt::format("cannot read the folder '{}': {}; check its permissions", folder.string(), why.message()));
    }
    return files;
}

std::optional<double> modified_at(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<double>(status.st_mtim.tv_sec) + static_cast<double>(status.st_mtim.tv_nsec) * 1e-9;
}

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Removes the leading run of digits from `text` and returns it without leading zeros.
std::string_view take_number(std::string_view& text) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
    const auto first = std::find_if(text.begin(), end, [](char c) { return c != '0'; });
    const std::string_view number(first, end);
    text.remove_prefix(static_cast<std::size_t>(end - text.begin()));
    return number;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
    std::string_view rest_a = a;
    std::string_view rest_b = b;
    while (!rest_a.empty() && !rest_b.empty()) {
        if (is_digit(rest_a.front()) && is_digit(rest_b.front())) {
            const auto number_a = take_number(rest_a);
            const auto number_b = take_number(rest_b);
            if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
            if (number_a != number_b) return number_a < number_b;
        } else {
            if (rest_a.front() != rest_b.front()) return rest_a.front() < rest_b.front();
            rest_a.remove_prefix(1);
            rest_b.remove_prefix(1);
        }
    }
    if (rest_a.empty() != rest_b.empty()) return rest_a.empty();
    return a < b;
}

std::vector<std::string> expand_glob(const std::string& pattern) {
    // glob(3) recurses for each part of a path, without a limit.
    if (pattern.size() >= PATH_MAX) {
        constexpr std::size_t shown = 40;
        throw Error(ErrorCode::name_pattern_invalid,
                    fmt::format("'{}...': a pattern has {} bytes at most, as a path has, and this "
                                "has {}",
                                pattern.substr(0, shown), PATH_MAX - 1, pattern.size()));
    }
    glob_t found{};
    const std::unique_ptr<glob_t, void (*)(glob_t*)> owner(&found, &globfree);
    if (::glob(pattern.c_str(), 0, nullptr, &found) != 0) return {};
    return {found.gl_pathv, found.gl_pathv + found.gl_pathc};
}

}  // namespace vvr::video
