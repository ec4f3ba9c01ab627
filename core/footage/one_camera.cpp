#include "core/footage/one_camera.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fnmatch.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/media/input.h"

namespace vvr::footage {

namespace {

namespace fs = std::filesystem;

using Files = std::vector<std::string>;

std::string_view folder_of(std::string_view path) {
    const auto slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string_view file_of(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

/// Escapes text for use in a glob.
std::string literal(std::string_view text) {
    std::string pattern;
    for (const char c : text) {
        if (std::string_view("*?[\\").find(c) != std::string_view::npos) pattern += '\\';
        pattern += c;
    }
    return pattern;
}

/// Length in bytes of the folders that all paths have in common.
std::size_t common_folders(const Files& paths) {
    std::string_view common = folder_of(paths.front());
    for (const std::string& path : paths) {
        while (!common.empty() && !(path.starts_with(common) && path[common.size()] == '/')) common = folder_of(common);
    }
    return common.empty() ? 0 : common.size() + 1;
}

/// A glob for the folders of all files. Empty if their depths differ.
std::optional<std::string> pattern_of_folders(const Files& files) {
    std::vector<std::vector<std::string>> parts;
    for (const std::string& file : files) {
        std::vector<std::string> folders;
        for (const fs::path& folder : fs::path(folder_of(file))) folders.push_back(folder.string());
        parts.push_back(std::move(folders));
    }
    fs::path pattern;
    for (std::size_t i = 0; i < parts.front().size(); ++i) {
        bool same = true;
        for (const auto& folders : parts) {
            if (folders.size() != parts.front().size()) return std::nullopt;
            same = same && folders[i] == parts.front()[i];
        }
        pattern /= same ? literal(parts.front()[i]) : "*";
    }
    return pattern.string();
}

/// The common prefix of all file names, up to and including the camera if it is there.
std::string_view common_begin(const Files& files, std::string_view camera) {
    std::string_view common = file_of(files.front());
    for (const std::string& file : files) {
        const auto end = std::ranges::mismatch(common, file_of(file)).in1;
        common = common.substr(0, static_cast<std::size_t>(end - common.begin()));
    }
    const std::string_view name = file_of(camera);
    return !name.empty() && common.starts_with(name) ? common.substr(0, name.size()) : common;
}

/// An input name that selects only the files of one camera: a folder, a glob or a file.
std::string choice_of(const Files& own, const Files& others, std::string_view camera) {
    const auto chooses = [&](const std::string& pattern, int flags) {
        const auto fits = [&](const std::string& file) { return ::fnmatch(pattern.c_str(), file.c_str(), flags) == 0; };
        return std::ranges::all_of(own, fits) && std::ranges::none_of(others, fits);
    };
    if (const auto folders = pattern_of_folders(own)) {
        if (!folders->empty() && chooses(*folders, FNM_PATHNAME | FNM_LEADING_DIR)) return *folders;
        const std::string ending = fs::path(own.front()).extension().string();
        for (const std::string& name : {fmt::format("{}*{}", literal(common_begin(own, camera)), literal(ending)),
                                        fmt::format("*{}{}", literal(file_of(camera)), literal(ending))}) {
            std::string files = (fs::path(*folders) / name).string();
            if (chooses(files, FNM_PATHNAME)) return files;
        }
    }
    return own.front();
}

}  // namespace

std::string whole_path(const std::string& name) {
    if (name == "-" || media::is_url(name)) return name;
    std::error_code error;
    const fs::path whole = fs::absolute(name, error);
    return error ? name : whole.lexically_normal().string();
}

std::string find_camera(const std::string& name, std::vector<Segment>& segments, const RecorderNames& schemes,
                        bool join) {
    Files paths;
    for (const Segment& segment : segments) paths.push_back(whole_path(segment.path));
    const std::size_t common = common_folders(paths);
    std::map<std::string, Files> cameras;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::string camera = schemes.camera_of(paths[i], common);
        segments[i].camera = camera;
        cameras[camera].push_back(segments[i].path);
    }
    if (cameras.size() == 1) return segments.front().camera;
    if (join) return "";
    Files own = cameras.begin()->second;
    std::string chosen = cameras.begin()->first;
    Files names;
    for (const auto& [camera, files] : cameras) {
        names.push_back(camera.empty() ? fmt::format("unknown ('{}')", shown_text(file_of(files.front())))
                                       : shown_text(camera));
        if (!chosen.empty()) continue;
        chosen = camera;
        own = files;
    }
    Files others;
    for (const auto& [camera, files] : cameras) {
        if (camera != chosen) others.insert(others.end(), files.begin(), files.end());
    }
    constexpr std::size_t named = 8;
    const std::size_t rest = names.size() - std::min(names.size(), named);
    names.resize(names.size() - rest);
    throw Error(
        ErrorCode::recording_mixed,
        fmt::format("'{}' has files of {}: {}{}; give those of one camera, for example '{}', or join them as one "
                    "recording",
                    name, counted(std::ssize(cameras), "camera"), fmt::join(names, ", "),
                    rest > 0 ? fmt::format(" and {} more", rest) : "", choice_of(own, others, chosen)),
        {"join"});
}

}  // namespace vvr::footage
