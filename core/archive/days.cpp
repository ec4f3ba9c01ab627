#include "core/archive/days.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <set>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "core/archive/limits.h"
#include "core/archive/names.h"
#include "core/base/local_time.h"
#include "core/base/plain_name.h"

namespace vvr::archive {

namespace {

/// When a clip begins, in seconds since 1970: as its name says, else when it was last written.
std::int64_t begin_of(const Clip& clip, const video::RecorderNames& names) {
    const std::int64_t written = clip.modified / 1'000'000'000;
    const auto named = names.read(clip.path).begin;
    const std::int64_t begin = named ? video::utc_of(*named, written) : written;
    return can_be_time(begin) ? begin : written;
}

std::string date_of(std::int64_t utc) {
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(utc + local_offset(utc))));
}

/// Names come from anywhere: one that leads out of the folder, or is hidden there, is none for a folder.
bool can_be_folder(const std::string& path) {
    return is_plain_path(path) && !path.starts_with('.') && path.find("/.") == std::string::npos;
}

}  // namespace

CameraDays group_by_day(const std::vector<Clip>& clips, const video::RecorderNames& names, const Settling& settling) {
    CameraDays grouped;
    std::map<std::string, CameraDay> days;
    std::map<std::string, std::int64_t> ahead;
    std::set<std::string> paths;
    std::set<std::string> refused;
    for (const Clip& clip : clips) paths.insert(clip.path);
    for (const Clip& clip : clips) {
        if (settling.waits_for(clip)) {
            ++grouped.waiting;
            continue;
        }
        const std::string camera = names.camera_of(clip.path);
        const std::string date = date_of(begin_of(clip, names));
        const std::string path = camera.empty() ? date : fmt::format("{}/{}", camera, date);
        if (!can_be_folder(path) || paths.contains(path)) {
            if (refused.insert(camera).second) {
                grouped.problems.push_back(
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
        std::int64_t& newest = settling.is_ahead(clip) ? ahead[path] : day.clip.modified;
        newest = std::max(newest, clip.modified);
        day.files.push_back(clip.path);
    }
    for (auto& [path, day] : days) {
        // A time of the future is that of a wrong clock: where there are others, it does not tell when the newest came.
        if (day.clip.modified == 0) day.clip.modified = ahead[path];
        std::ranges::sort(day.files);
        grouped.days.push_back(std::move(day));
    }
    return grouped;
}

}  // namespace vvr::archive
