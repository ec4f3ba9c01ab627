#include "core/archive/camera_days.h"

#include <algorithm>
#include <ctime>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "core/archive/output_files.h"
#include "core/base/file.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/footage/creation_time.h"
#include "core/footage/input_files.h"

namespace vvr::archive {

namespace {

constexpr std::int64_t seconds_per_day = 86'400;

/// When a clip was last written, seconds since 1970.
std::int64_t written_at(const Clip& clip) {
    return clip.modified / 1'000'000'000;
}

/// Names are untrusted: one that leads out of the folder or would be hidden can't be a folder.
bool can_be_folder(const std::string& path) {
    return is_plain_path(path) && !path.starts_with('.') && path.find("/.") == std::string::npos;
}

std::string path_of_day(const std::string& camera, const std::string& date, const DayRule& rule) {
    return fmt::format("{}{}{}{}", camera, camera.empty() ? "" : "/", date, rule.is_night() ? "-night" : "");
}

}  // namespace

std::optional<std::int64_t> begin_of_clip(const Clip& clip, const footage::RecorderNames& names, const DayRule& rule,
                                          const std::filesystem::path& in) {
    std::optional<std::int64_t> begin;
    if (const auto named = names.read(clip.path).begin) {
        begin = footage::utc_of(*named, written_at(clip));
    } else if (rule.by_container) {
        begin = footage::creation_time_of(in / clip.path);
    }
    return begin && can_be_time(*begin) ? begin : std::nullopt;
}

std::string date_of(std::int64_t utc, const DayRule& rule) {
    const std::int64_t begins = std::chrono::seconds(rule.begins).count();
    const std::int64_t wall = utc + local_offset(utc) - begins;
    std::int64_t date = wall - ((wall % seconds_per_day) + seconds_per_day) % seconds_per_day;
    // Where the clock goes back over the beginning of a day, that day has begun all the same.
    if (const std::int64_t next = date + seconds_per_day; utc_of_local(next + begins) <= utc) date = next;
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(date)));
}

std::string words_of_day(const std::string& date, const DayRule& rule) {
    return rule.is_night() ? "night of " + date : date;
}

CameraDays group_by_day(const std::vector<Clip>& clips, const footage::RecorderNames& names, const Settling& settling,
                        const DayRule& rule, const std::filesystem::path& in) {
    CameraDays grouped;
    std::map<std::string, CameraDay> days;
    std::map<std::string, std::int64_t> ahead;
    std::set<std::string> paths;
    std::set<std::string> refused;
    for (const Clip& clip : clips) paths.insert(clip.path);
    std::vector<Clip> ordered = clips;
    const auto is_picture = [](const Clip& clip) { return footage::is_picture_name(clip.path); };
    std::stable_partition(ordered.begin(), ordered.end(), std::not_fn(is_picture));
    for (const Clip& clip : ordered) {
        if (settling.waits_for(clip)) {
            ++grouped.waiting;
            continue;
        }
        const std::string camera = names.camera_of(clip.path);
        const std::optional<std::int64_t> begin = begin_of_clip(clip, names, rule, in);
        if (is_picture(clip) && !begin) continue;
        const std::string date = date_of(begin.value_or(written_at(clip)), rule);
        const std::string path = path_of_day(camera, date, rule);
        if (!can_be_folder(path) || paths.contains(path)) {
            if (refused.insert(camera).second) {
                grouped.problems.push_back(
                    {clip.path,
                     fmt::format(
                         "its camera '{}' cannot name a folder of pictures; give a pattern of file names that finds "
                         "another camera",
                         text_of_path(camera))});
            }
            continue;
        }
        CameraDay& day = days[path];
        if (is_picture(clip) && !day.files.empty() && !footage::is_picture_name(day.files.front())) continue;
        day.camera = camera;
        day.date = date;
        day.rule = rule;
        day.clip.path = path;
        day.clip.size += clip.size;
        std::int64_t& newest = settling.is_ahead(clip) ? ahead[path] : day.clip.modified;
        newest = std::max(newest, clip.modified);
        day.files.push_back(clip.path);
        if (!begin) day.undated.push_back(clip.path);
    }
    for (auto& [path, day] : days) {
        // A future time comes from a wrong clock: it counts only where the day has no other.
        if (day.clip.modified == 0) day.clip.modified = ahead[path];
        std::ranges::sort(day.files);
        grouped.days.push_back(std::move(day));
    }
    return grouped;
}

}  // namespace vvr::archive
