#include "core/footage/input_files.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>

#include <glob.h>
#include <strings.h>

#include <climits>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/media/input.h"

namespace vvr::footage {

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

bool is_system_folder_name(const std::string& name) {
    constexpr std::array names{"#recycle", "@Recycle",     "@Recently-Snapshot", "#snapshot",
                               "@eaDir",   "$RECYCLE.BIN", "lost+found",         "System Volume Information"};
    return std::ranges::any_of(names, [&](const char* one) { return ::strcasecmp(one, name.c_str()) == 0; });
}

std::vector<std::string> video_files_in(const fs::path& folder) {
    std::vector<std::string> files;
    std::error_code why;
    const auto options = fs::directory_options::skip_permission_denied;
    for (fs::recursive_directory_iterator entry(folder, options, why);
         !why && entry != fs::recursive_directory_iterator(); entry.increment(why)) {
        const std::string name = entry->path().filename().string();
        std::error_code none;
        if (name.starts_with('.') || is_system_folder_name(name)) {
            entry.disable_recursion_pending();
        } else if (is_video_name(name) && entry->is_regular_file(none)) {
            files.push_back(entry->path().string());
        }
    }
    if (why)
        throw system_error(why.value(), fmt::format("cannot read the folder '{}'", folder.string()),
                           "check its permissions");
    return files;
}

namespace {

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
                    fmt::format("the pattern '{}...' has {} bytes, more than the limit of {} bytes; use a shorter one",
                                pattern.substr(0, shown), pattern.size(), PATH_MAX - 1));
    }
    glob_t found{};
    const std::unique_ptr<glob_t, void (*)(glob_t*)> owner(&found, &globfree);
    if (::glob(pattern.c_str(), 0, nullptr, &found) != 0) return {};
    return {found.gl_pathv, found.gl_pathv + found.gl_pathc};
}

// ---- Lists

namespace {

constexpr std::string_view list_extension = ".txt";
constexpr std::uintmax_t most_list_bytes = 16 * 1024 * 1024;

[[noreturn]] void refuse_line(const std::string& list, std::int64_t number, std::string_view why) {
    throw Error(ErrorCode::file_invalid,
                fmt::format("'{}', line {}: {}; each line of a list must be the path of a video file in the list's "
                            "folder or below",
                            list, number, why));
}

}  // namespace

std::vector<std::string> files_of_list(const std::string& list) {
    std::error_code none;
    if (fs::file_size(list, none) > most_list_bytes) {
        throw Error(ErrorCode::file_too_large,
                    fmt::format("cannot read '{}': a list of files may have at most {} MB; split it", list,
                                most_list_bytes / 1024 / 1024));
    }
    std::ifstream text(list);
    if (!text) throw system_error(errno, fmt::format("cannot read '{}'", list), "check its permissions");
    const fs::path folder = fs::path(list).parent_path();
    const fs::path real_folder = fs::canonical(folder.empty() ? "." : folder, none);
    std::vector<std::string> files;
    std::string line;
    for (std::int64_t number = 1; std::getline(text, line); ++number) {
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty() || line.starts_with('#')) continue;
        if (!is_plain_path(line)) refuse_line(list, number, "the path is not within the list's folder");
        const fs::path file = folder / line;
        const fs::path real = fs::canonical(file, none);
        if (none || !fs::is_regular_file(real, none)) {
            refuse_line(list, number, fmt::format("file '{}' not found", file.string()));
        }
        const fs::path below = real.lexically_relative(real_folder);
        if (below.empty() || *below.begin() == "..")
            refuse_line(list, number, "the link leads out of the list's folder");
        files.push_back(file.string());
    }
    return files;
}

bool is_list(const std::string& name) {
    std::error_code none;
    if (extension_of(name) != list_extension || !fs::is_regular_file(name, none)) return false;
    std::array<char, 512> begin{};
    std::ifstream file(name, std::ios::binary);
    file.read(begin.data(), begin.size());
    return std::none_of(begin.begin(), begin.begin() + file.gcount(), [](char c) { return c >= 0 && c < '\t'; });
}

// ---- Pictures

namespace {

/// The names of the regular files in a folder, without hidden files.
std::vector<std::string> files_in(const fs::path& folder, const std::string& asked) {
    std::vector<std::string> names;
    std::error_code why;
    for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, why);
         !why && entry != fs::directory_iterator(); entry.increment(why)) {
        std::error_code ignored;
        std::string file = entry->path().filename().string();
        if (!file.starts_with('.') && entry->is_regular_file(ignored)) names.push_back(std::move(file));
    }
    if (why)
        throw system_error(why.value(), fmt::format("cannot read the folder of '{}'", asked),
                           "check its name and permissions");
    return names;
}

std::vector<std::string> pictures_in(const std::string& folder) {
    const auto names = files_in(folder, folder);
    std::vector<std::string> pictures;
    for (const auto& name : names) {
        if (is_picture_name(name)) pictures.push_back((fs::path(folder) / name).string());
    }
    if (pictures.empty()) {
        throw Error(
            ErrorCode::not_video,
            fmt::format(
                "the folder '{}' has no pictures or videos (found: {}); give a video file, or a folder of pictures "
                "(png, jpg, tif, ...)",
                folder, counted(std::ssize(names), "file")));
    }
    return pictures;
}

/// The parts of "frame%05d.png": the text before and after the number, and its minimum width.
struct NumberPattern {
    std::string before;
    std::string after;
    std::size_t width = 0;
    bool zeros = false;
};

[[noreturn]] void throw_bad_pattern(const std::string& name) {
    throw Error(ErrorCode::name_pattern_invalid,
                fmt::format("'{}': a pattern of pictures must have exactly one number in its file name, as %d or %05d; "
                            "write %% for a percent sign",
                            name));
}

NumberPattern parse_pattern(std::string_view file, const std::string& name) {
    NumberPattern pattern;
    bool has_number = false;
    while (!file.empty()) {
        std::string& literal = has_number ? pattern.after : pattern.before;
        const char c = file.front();
        file.remove_prefix(1);
        if (c != '%') {
            literal += c;
            continue;
        }
        if (file.starts_with('%')) {
            literal += '%';
            file.remove_prefix(1);
            continue;
        }
        pattern.zeros = file.starts_with('0');
        const auto end = file.find_first_not_of("0123456789");
        if (has_number || end == std::string_view::npos || end > 3 ||
            (file[end] != 'd' && file[end] != 'i' && file[end] != 'u')) {
            throw_bad_pattern(name);
        }
        std::from_chars(file.data(), file.data() + end, pattern.width);
        file.remove_prefix(end + 1);
        has_number = true;
    }
    if (!has_number) throw_bad_pattern(name);
    return pattern;
}

bool matches(const NumberPattern& pattern, std::string_view file) {
    if (file.size() <= pattern.before.size() + pattern.after.size()) return false;
    if (!file.starts_with(pattern.before) || !file.ends_with(pattern.after)) return false;
    const auto number = file.substr(pattern.before.size(), file.size() - pattern.before.size() - pattern.after.size());
    if (number.find_first_not_of("0123456789") != std::string_view::npos) return false;
    if (number.size() < (pattern.zeros ? pattern.width : 1)) return false;
    // printf pads only up to the width.
    return number.size() == 1 || number.front() != '0' || (pattern.zeros && number.size() == pattern.width);
}

std::vector<std::string> matches_of_pattern(const std::string& name) {
    const fs::path path(name);
    if (path.parent_path().string().find('%') != std::string::npos && !fs::exists(path.parent_path())) {
        throw_bad_pattern(name);
    }
    const auto pattern = parse_pattern(path.filename().string(), name);
    std::vector<std::string> files;
    for (const auto& file : files_in(path.parent_path(), name)) {
        if (matches(pattern, file)) files.push_back((path.parent_path() / file).string());
    }
    return files;
}

}  // namespace

std::optional<std::vector<std::string>> list_pictures(const std::string& name) {
    std::error_code ignored;
    const auto status = fs::status(name, ignored);
    const bool is_folder = fs::is_directory(status);
    const bool has_wildcard = name.find_first_of("%*?[") != std::string::npos;
    if (!is_folder && (name == "-" || fs::exists(status) || media::is_url(name) || !has_wildcard)) return std::nullopt;

    std::vector<std::string> files;
    if (is_folder) {
        files = pictures_in(name);
    } else if (name.find('%') != std::string::npos) {
        files = matches_of_pattern(name);
    } else {
        files = expand_glob(name);
        std::erase_if(files, [&](const std::string& match) { return !fs::is_regular_file(match, ignored); });
    }
    if (files.empty()) {
        throw Error(
            ErrorCode::file_not_found,
            fmt::format("cannot read '{}': no file matches this pattern; check the pattern and the folder", name));
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return natural_less(a, b); });
    return files;
}

namespace {

using Paths = std::vector<fs::path>;

/// Adds all files that may be read from a folder: videos of its subfolders, pictures, parts of an extraction, lists.
void add_folder(const fs::path& folder, Paths& files) {
    std::error_code none;
    const bool extracted = fs::exists(folder / "manifest.json", none);
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, none);
    for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored)) continue;
        const std::string name = entry->path().filename().string();
        const std::string extension = extension_of(name);
        const bool flat = is_picture_name(name) || extension == list_extension || extension == ".flo";
        if (extracted || is_video_name(name) || (flat && entry.depth() == 0)) files.push_back(entry->path());
    }
}

/// Adds the files in a list, even if other lines are invalid.
void add_list(const fs::path& list, Paths& files) {
    std::error_code none;
    if (fs::file_size(list, none) > most_list_bytes || none) return;
    std::ifstream text(list);
    for (std::string line; std::getline(text, line);) {
        if (line.ends_with('\r')) line.pop_back();
        const fs::path file = list.parent_path() / line;
        if (!line.empty() && fs::is_regular_file(file, none)) files.push_back(file);
    }
}

void add(const std::string& name, Paths& files) {
    std::error_code none;
    if (fs::is_directory(name, none)) return add_folder(name, files);
    if (fs::is_regular_file(name, none)) {
        files.emplace_back(name);
        if (extension_of(name) == list_extension) add_list(name, files);
        return;
    }
    if (fs::exists(name, none)) return;
    for (const std::string& match : expand_glob(name)) add(match, files);
    if (name.find('%') == std::string::npos) return;
    if (const auto pictures = list_pictures(name)) files.insert(files.end(), pictures->begin(), pictures->end());
}

}  // namespace

Paths files_of_input(const std::string& name) {
    if (name == "-") return {"/dev/stdin"};
    Paths files;
    try {
        add(name, files);
        if (name.starts_with('@')) add(name.substr(1), files);
    } catch (const Error&) {
        return files;
    }
    return files;
}

}  // namespace vvr::footage
