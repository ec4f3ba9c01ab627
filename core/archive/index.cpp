#include "core/archive/index.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include <nlohmann/json.hpp>

#include "core/json_text.h"
#include "core/local_time.h"
#include "core/page/text.h"
#include "index_files.h"

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

Json row_of(const Sidecar& sidecar, const Place& place, const std::vector<std::string>& cameras) {
    const auto camera = std::ranges::lower_bound(cameras, place.camera) - cameras.begin();
    Json row{camera,
             url_of_path(sidecar.clip.path),
             place.begin,
             std::round(sidecar.seconds * 10) / 10,
             sidecar.events ? Json(*sidecar.events) : Json(),
             files_of(sidecar)};
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

std::string make_index(const std::vector<Sidecar>& sidecars, const RecorderNames& names) {
    std::vector<Place> places;
    for (const Sidecar& sidecar : sidecars) places.push_back(place_of(sidecar, names));
    std::set<std::string> found;
    for (const Place& place : places) found.insert(place.camera);
    const std::vector<std::string> cameras(found.begin(), found.end());
    Json json{{"cameras", Json::array()}, {"zone", zone_of(places)}, {"clips", Json::array()}};
    for (const std::string& camera : cameras) json["cameras"].push_back(text_of_path(camera));
    json["days"] = Json::array();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Json row = row_of(sidecars[i], places[i], cameras);
        const auto& day = sidecars[i].day;
        if (day) {
            json["days"].push_back({{"date", day->date}, {"clips", day->clips}, {"row", row}});
        } else {
            json["clips"].push_back(row);
        }
    }
    return fill(index_files::index_html, {
                                             {"script policy", policy_hash(index_files::index_js)},
                                             {"style policy", policy_hash(index_files::index_css)},
                                             {"style", std::string(index_files::index_css)},
                                             {"script", std::string(index_files::index_js)},
                                             {"data", script_json(json_text(json, -1, true))},
                                         });
}

}  // namespace vvr
