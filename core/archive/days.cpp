#include "core/archive/days.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <set>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "core/archive/names.h"
#include "core/local_time.h"
#include "core/plain_name.h"

namespace vvr {

namespace {

std::string date_of(std::int64_t utc) {
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(utc + local_offset(utc))));
}

/// Names come from anywhere: one that leads out of the folder, or is hidden there, is none for a folder.
bool can_be_folder(const std::string& path) {
    return is_plain_path(path) && !path.starts_with('.') && path.find("/.") == std::string::npos;
}

}  // namespace

std::vector<CameraDay> group_by_day(const std::vector<Clip>& clips, const RecorderNames& names, std::int64_t settled,
                                    std::vector<ScanProblem>& problems) {
    std::map<std::string, CameraDay> days;
    std::set<std::string> paths;
    std::set<std::string> refused;
    for (const Clip& clip : clips) paths.insert(clip.path);
    for (const Clip& clip : clips) {
        if (clip.modified > settled) continue;
        const std::int64_t written = clip.modified / 1'000'000'000;
        const auto named = names.read(clip.path).begin;
        const std::string camera = names.camera_of(clip.path);
        const std::string date = date_of(named ? utc_of(*named, written) : written);
        const std::string path = camera.empty() ? date : fmt::format("{}/{}", camera, date);
        if (!can_be_folder(path) || paths.contains(path)) {
            if (refused.insert(camera).second) {
                problems.push_back(
                    {clip.path, fmt::format("its camera '{}' cannot be the name of a folder for pictures; "
                                            "names can tell another",
                                            text_of_path(camera))});
            }
            continue;
        }
        CameraDay& day = days[path];
        day.camera = camera;
        day.date = date;
        day.clip.path = path;
        day.clip.size += clip.size;
        day.clip.modified = std::max(day.clip.modified, clip.modified);
        day.files.push_back(clip.path);
    }
    std::vector<CameraDay> grouped;
    for (auto& [path, day] : days) grouped.push_back(std::move(day));
    return grouped;
}

}  // namespace vvr
