#include "core/video/input_files.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file_name.h"
#include "core/video/input.h"
#include "core/video/video_files.h"

namespace vvr::video {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 19> picture_extensions{"png",  "jpg", "jpeg", "jpe", "bmp", "tif", "tiff",
                                                              "webp", "ppm", "pgm",  "pbm", "pnm", "pam", "tga",
                                                              "exr",  "dpx", "jp2",  "sgi", "gif"};

bool has_picture_extension(const fs::path& path) {
    std::string extension = path.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return std::find(picture_extensions.begin(), picture_extensions.end(), extension) != picture_extensions.end();
}

/// The names of the regular files in a folder, hidden ones left out.
std::vector<std::string> files_in(const fs::path& folder, const std::string& asked) {
    std::vector<std::string> names;
    std::error_code why;
    for (auto entry = fs::directory_iterator(folder.empty() ? "." : folder, why);
         !why && entry != fs::directory_iterator(); entry.increment(why)) {
        std::error_code ignored;
        std::string file = entry->path().filename().string();
        if (!file.starts_with('.') && entry->is_regular_file(ignored)) names.push_back(std::move(file));
    }
    if (why) {
        throw Error(ErrorKind::io, fmt::format("cannot read the folder of '{}': {}; check its name and permissions",
                                               asked, why.message()));
    }
    return names;
}

std::vector<std::string> pictures_in(const std::string& folder) {
    const auto names = files_in(folder, folder);
    std::vector<std::string> pictures;
    for (const auto& name : names) {
        if (has_picture_extension(name)) pictures.push_back((fs::path(folder) / name).string());
    }
    if (pictures.empty()) {
        throw Error(
            ErrorKind::not_video,
            fmt::format(
                "'{}' is a folder without frames: {}; give a video file, or a folder of pictures (png, jpg, tif, ...)",
                folder,
                names.empty() ? std::string("it holds no file")
                              : fmt::format("none of its {} file(s) is a picture", names.size())));
    }
    return pictures;
}

std::vector<std::string> expand_glob_pattern(const std::string& pattern) {
    std::vector<std::string> files;
    for (std::string& match : expand_glob(pattern)) {
        std::error_code ignored;
        if (fs::is_regular_file(match, ignored)) files.push_back(std::move(match));
    }
    return files;
}

/// "frame%05d.png" in parts: the text before and after the number, and its least width.
struct NumberPattern {
    std::string before;
    std::string after;
    std::size_t width = 0;
    bool zeros = false;
};

[[noreturn]] void throw_bad_pattern(const std::string& name) {
    throw Error(ErrorKind::usage,
                fmt::format("'{}': a pattern of pictures has one number in its file name, written %d or "
                            "%05d, and %% for a percent sign",
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
    // printf pads up to the width and never beyond it.
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

bool is_picture_name(const std::string& name) {
    return has_picture_extension(name);
}

std::optional<std::vector<std::string>> list_pictures(const std::string& name) {
    std::error_code ignored;
    const auto status = fs::status(name, ignored);
    const bool is_folder = fs::is_directory(status);
    const bool has_wildcard = name.find_first_of("%*?[") != std::string::npos;
    if (!is_folder && (name == "-" || fs::exists(status) || is_url(name) || !has_wildcard)) return std::nullopt;

    std::vector<std::string> files;
    if (is_folder) {
        files = pictures_in(name);
    } else if (name.find('%') != std::string::npos) {
        files = matches_of_pattern(name);
    } else {
        files = expand_glob_pattern(name);
    }
    if (files.empty()) {
        throw Error(ErrorKind::io,
                    fmt::format("cannot read '{}': no file matches this pattern; check it and the folder", name));
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return natural_less(a, b); });
    return files;
}

namespace {

using Paths = std::vector<fs::path>;

/// A folder is read as a recording, which has folders in it, as pictures, as an extraction, or as lists or flow.
void add_folder(const fs::path& folder, Paths& files) {
    std::error_code none;
    const bool extracted = fs::exists(folder / "manifest.json", none);
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, none);
    for (; !none && entry != fs::recursive_directory_iterator(); entry.increment(none)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored)) continue;
        const std::string name = entry->path().filename().string();
        const std::string ending = extension_of(name);
        const bool flat = is_picture_name(name) || ending == ".txt" || ending == ".flo";
        if (extracted || is_video_name(name) || (flat && entry.depth() == 0)) files.push_back(entry->path());
    }
}

/// The files that a list names, whatever else is wrong with it.
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
        if (extension_of(name) == ".txt") add_list(name, files);
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

}  // namespace vvr::video
