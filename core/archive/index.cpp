#include "core/archive/index.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/json_text.h"
#include "core/local_time.h"
#include "core/page/text.h"
#include "index_files.h"
#include "index_script.h"
#include "shared_files.h"

namespace vvr {

namespace {

using Json = nlohmann::ordered_json;

/// "2026-11-21 08:00:07", UTC.
std::optional<std::int64_t> seconds_of(const std::string& text) {
    int year = 0;
    unsigned month = 0, day = 0, hour = 0, minute = 0, second = 0;
    if (std::sscanf(text.c_str(), "%d-%u-%u %u:%u:%u", &year, &month, &day, &hour, &minute, &second) != 6) return {};
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)};
    if (!date.ok()) return {};
    const std::chrono::sys_seconds time = std::chrono::sys_days(date) + std::chrono::hours(hour) +
                                          std::chrono::minutes(minute) + std::chrono::seconds(second);
    return time.time_since_epoch().count();
}

int files_of(const Sidecar& sidecar) {
    int bits = 0;
    for (const OutputKind kind : sidecar.files) bits |= 1 << static_cast<int>(kind);
    return bits;
}

/// A clip's place in the index.
struct Place {
    std::string camera;
    std::int64_t begin = 0;  ///< seconds since 1970
};

Place place_of(const Sidecar& sidecar, const RecorderNames& names) {
    return {sidecar.day ? sidecar.day->camera : names.camera_of(sidecar.clip.path), begin_of(sidecar, names)};
}

/// Seconds of what lay there for longest and of what stood for longest, and how many things were taken; null where it
/// is not known.
Json badges_of(const Sidecar& sidecar) {
    if (sidecar.found.empty()) return {};
    int left = 0;
    int stood = 0;
    int taken = 0;
    for (const FoundEvent& event : sidecar.found) {
        const int lasts = event.path.empty() ? 0 : event.path.back().time - event.path.front().time;
        if (event.kind == 'l') left = std::max(left, lasts);
        if (event.kind == 's') stood = std::max(stood, event.still);
        if (event.kind == 't') ++taken;
    }
    return {left / 10.0, stood / 10.0, taken};
}

constexpr int gone_bit = 1 << 8;
constexpr int damaged_bit = 1 << 9;

Json row_of(const Sidecar& sidecar, const Place& place, const std::vector<std::string>& cameras, bool gone) {
    const auto camera = std::ranges::lower_bound(cameras, place.camera) - cameras.begin();
    Json row{camera,
             url_of_path(sidecar.clip.path),
             place.begin,
             std::round(sidecar.seconds * 10) / 10,
             sidecar.events ? Json(*sidecar.events) : Json(),
             files_of(sidecar) | (gone ? gone_bit : 0) | (sidecar.damaged > 0 ? damaged_bit : 0),
             badges_of(sidecar)};
    if (sidecar.state == Sidecar::State::failed) {
        row.push_back(sidecar.status);
        row.push_back(sidecar.reason);
        row.push_back(sidecar.tries);
    }
    return row;
}

/// What the clocks on the walls of the machine that draws showed: [from, seconds ahead of UTC, name] each, from the
/// first clip on.
Json zone_of(const std::vector<Place>& places) {
    Json zone = Json::array();
    if (places.empty()) return zone;
    const auto [first, last] = std::ranges::minmax(places, {}, &Place::begin);
    for (const ZoneChange& change : zone_changes(first.begin, last.begin)) {
        zone.push_back({change.from, change.offset, zone_text(change.from)});
    }
    return zone;
}

constexpr std::string_view day_file_begin = "index.";
constexpr std::string_view day_file_end = ".js";

/// The day on the wall's calendar: "2026-11-21".
std::string day_of(std::int64_t utc) {
    const std::chrono::sys_seconds wall{std::chrono::seconds(utc + local_offset(utc))};
    const std::chrono::year_month_day date{std::chrono::floor<std::chrono::days>(wall)};
    return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(date.year()), static_cast<unsigned>(date.month()),
                       static_cast<unsigned>(date.day()));
}

}  // namespace

std::int64_t begin_of(const Sidecar& sidecar, const RecorderNames& names) {
    const std::int64_t written = sidecar.clip.modified / 1'000'000'000 - std::llround(sidecar.seconds);
    const auto named = sidecar.day ? std::nullopt : names.read(sidecar.clip.path).begin;
    if (named) return utc_of(*named, written);
    if (sidecar.recorded) {
        if (const auto seconds = seconds_of(*sidecar.recorded)) return *seconds;
    }
    return written;
}

DayFiles make_day_files(const std::vector<Sidecar>& sidecars, const RecorderNames& names) {
    // Where clips of a camera are there one by one, a picture of its whole day would tell of them again.
    std::set<std::string> one_by_one;
    for (const Sidecar& sidecar : sidecars) {
        if (!sidecar.day) one_by_one.insert(names.camera_of(sidecar.clip.path));
    }
    std::map<std::string, Json> days;
    for (const Sidecar& sidecar : sidecars) {
        if (sidecar.found.empty() || (sidecar.day && one_by_one.contains(sidecar.day->camera))) continue;
        Json events = Json::array();
        for (const FoundEvent& event : sidecar.found) events.push_back(json_of(event));
        Json& day = days[day_of(begin_of(sidecar, names))];
        day.push_back({url_of_path(sidecar.clip.path), std::move(events)});
    }
    DayFiles files;
    for (const auto& [day, clips] : days) {
        files[fmt::format("{}{}{}", day_file_begin, day, day_file_end)] =
            fmt::format("vvrDay(\"{}\",{});\n", day, script_json(json_text(clips, -1, true)));
    }
    return files;
}

bool is_day_file(std::string_view name) {
    constexpr std::string_view date = "dddd-dd-dd";
    if (!name.starts_with(day_file_begin) || !name.ends_with(day_file_end)) return false;
    name.remove_prefix(day_file_begin.size());
    if (name.size() != date.size() + day_file_end.size()) return false;
    return std::ranges::equal(name.substr(0, date.size()), date,
                              [](char c, char form) { return form == 'd' ? c >= '0' && c <= '9' : c == form; });
}

std::string make_index(const std::vector<Sidecar>& sidecars, const RecorderNames& names,
                       const std::set<std::string>& gone) {
    std::vector<Place> places;
    for (const Sidecar& sidecar : sidecars) places.push_back(place_of(sidecar, names));
    std::set<std::string> found;
    for (const Place& place : places) found.insert(place.camera);
    const std::vector<std::string> cameras(found.begin(), found.end());
    Json json{{"cameras", Json::array()}, {"zone", zone_of(places)}, {"clips", Json::array()}};
    for (const std::string& camera : cameras) json["cameras"].push_back(text_of_path(camera));
    json["recordings"] = Json::array();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Json row = row_of(sidecars[i], places[i], cameras, gone.contains(sidecars[i].clip.path));
        if (const auto& day = sidecars[i].day) {
            json["recordings"].push_back({{"date", day->date}, {"clips", day->clips}, {"row", row}});
        } else {
            json["clips"].push_back(row);
        }
    }
    std::set<std::string> days;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!sidecars[i].found.empty()) days.insert(day_of(places[i].begin));
    }
    json["days"] = days;
    const std::string style = std::string(shared_files::theme_css) + std::string(index_files::index_css);
    const std::string script =
        joined(std::string(shared_files::common_js) + std::string(shared_files::place_js), index_script::files);
    return fill(index_files::index_html, {
                                             {"script policy", policy_hash(script)},
                                             {"style policy", policy_hash(style)},
                                             {"style", style},
                                             {"script", script},
                                             {"data", script_json(json_text(json, -1, true))},
                                         });
}

}  // namespace vvr
