#include "core/footage/segments.h"

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include <fnmatch.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/media/container.h"
#include "core/media/demuxer.h"
#include "core/media/input.h"

namespace vvr::footage {

namespace {

constexpr std::size_t fewest = 4;  // files; fewer may be alike by chance

/// A file and the time until the next one begins.
struct Paced {
    const Segment* segment = nullptr;
    double pace = 0;  ///< seconds
};

/// The files after which the next begins as soon as usual. Empty if this is not the rule, as in clips of motion.
std::vector<Paced> paced_files(const std::vector<Segment>& segments) {
    constexpr double near = 0.1;  // of the usual
    std::vector<Paced> paced;
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
        if (!segments[i].begin || !segments[i + 1].begin) return {};
        paced.push_back({&segments[i], static_cast<double>(*segments[i + 1].begin - *segments[i].begin)});
    }
    if (paced.size() < fewest) return {};
    std::vector<Paced> sorted = paced;
    std::ranges::sort(sorted, {}, &Paced::pace);
    const double usual = sorted[sorted.size() / 2].pace;
    const std::size_t all = paced.size();
    std::erase_if(paced, [&](const Paced& one) { return std::abs(one.pace - usual) > near * usual; });
    if (paced.size() < fewest || 2 * paced.size() < all) paced.clear();
    return paced;
}

/// How a file fills its time.
struct Filling {
    double ratio = 0;  ///< of its time to its length
    double length = 0;
    double rate = 0;      ///< frames per second, as stated
    bool closed = false;  ///< it was last written when its frames end, not when the next file begins
};

std::optional<Filling> filling_of(const Paced& file) {
    constexpr double tolerance = 1;  // seconds
    constexpr double most = 1.6;     // of the length
    try {
        const media::Demuxer demuxer(media::open_input(file.segment->path), media::Demuxer::Kind::video, 0);
        const media::ClipHeader header = media::header_of(demuxer);
        if (header.length <= 0 || header.rate <= 0) return std::nullopt;
        if (file.pace - header.length <= tolerance || file.pace > most * header.length) return std::nullopt;
        const double written = modified_at(file.segment->path).value_or(0);
        const double end = static_cast<double>(*file.segment->begin) + header.length;
        return Filling{file.pace / header.length, header.length, header.rate, std::abs(written - end) < 2 * tolerance};
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::limit) throw;
        return std::nullopt;  // reported when it is read
    }
}

}  // namespace

std::optional<SteadyRate> find_steady_rate(const std::vector<Segment>& segments) {
    constexpr std::size_t most = 12;  // headers that are read
    constexpr double near = 0.05;
    const std::vector<Paced> paced = paced_files(segments);
    std::vector<Filling> files;
    const std::size_t step = std::max<std::size_t>(1, paced.size() / most);
    for (std::size_t i = 0; i < paced.size(); i += step) {
        const auto filling = filling_of(paced[i]);
        if (!filling) return std::nullopt;
        files.push_back(*filling);
    }
    if (files.empty() || std::ranges::all_of(files, &Filling::closed)) return std::nullopt;
    std::ranges::sort(files, {}, &Filling::ratio);
    const Filling& usual = files[files.size() / 2];
    const double rounding = 1 / usual.length;  // names have whole seconds
    for (const Filling& one : files) {
        if (std::abs(one.ratio - usual.ratio) > near * usual.ratio + rounding) return std::nullopt;
        if (std::abs(one.rate - usual.rate) > near * usual.rate) return std::nullopt;
    }
    return SteadyRate{usual.rate / usual.ratio, usual.rate, usual.length, usual.ratio * usual.length};
}

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
