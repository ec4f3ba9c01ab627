#include "core/archive/index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/base/wall_clock.h"
#include "core/detector/classes.h"
#include "core/page/html.h"
#include "core/page/moments.h"
#include "core/tracking/event_kind.h"
#include "web_files.h"

namespace vvr::archive {

namespace {

/// Parses "2026-11-21 08:00:07", UTC; nothing for another format or an impossible time.
std::optional<std::int64_t> seconds_of(const std::string& text) {
    constexpr std::string_view form = "2026-11-21 08:00:07";
    const auto seconds = text.size() == form.size() && text[10] == ' ' ? parse_date_time(text) : std::nullopt;
    return seconds && can_be_time(*seconds) ? seconds : std::nullopt;
}

int files_of(const Sidecar& sidecar) {
    int bits = 0;
    for (const OutputKind kind : sidecar.files) bits |= 1 << static_cast<int>(kind);
    return bits;
}

/// An entry of the index.
struct Place {
    std::string camera;
    Begin begin;
    double seconds = 0;  ///< length
};

Place place_of(const Sidecar& sidecar, const footage::RecorderNames& names) {
    return {sidecar.day ? sidecar.day->camera : names.camera_of(sidecar.clip.path), begin_of(sidecar, names),
            sidecar.seconds};
}

/// What the index says of a clip's events of a kind: seconds or a number; 0 = nothing.
Json tally_of(const tracking::EventKindRow& row, const std::vector<FoundEvent>& found) {
    int most = 0;
    int count = 0;
    for (const FoundEvent& event : found) {
        if (event.kind != row.kind) continue;
        most = std::max(most, row.tally == tracking::Tally::still ? event.still : length_of(event));
        ++count;
    }
    switch (row.tally) {
        case tracking::Tally::none:
            return 0;
        case tracking::Tally::count:
            return count;
        case tracking::Tally::lasts:
        case tracking::Tally::still:
            return most / 10.0;
    }
    return {};
}

/// The tallies of all kinds, the most important first; null if unknown.
Json tallies_of(const Sidecar& sidecar) {
    if (sidecar.found.empty()) return {};
    return list_of(tracking::ranked_kinds(), [&](const auto& row) { return tally_of(row, sidecar.found); });
}

/// The classes of a clip's objects; null if none is known.
Json classes_of(const Sidecar& sidecar) {
    std::set<std::string_view> names;
    for (const FoundEvent& event : sidecar.found) {
        if (event.what != nullptr) names.insert(event.what->name);
    }
    return names.empty() ? Json() : Json(names);
}

/// The classes of all objects, by group.
Json classes_by_group(const std::vector<Sidecar>& sidecars) {
    std::map<detector::Group, std::set<std::string_view>> classes;
    for (const Sidecar& sidecar : sidecars) {
        for (const FoundEvent& event : sidecar.found) {
            if (event.what != nullptr) classes[event.what->group].insert(event.what->name);
        }
    }
    Json json = Json::object();
    for (const auto& [group, names] : classes) json[std::string(detector::name_of(group))] = names;
    return json;
}

/// The filters by kind, the most important first.
std::vector<const tracking::KindChoice*> choices_of_kinds() {
    std::vector<const tracking::KindChoice*> choices;
    for (const tracking::EventKindRow& row : tracking::ranked_kinds()) {
        if (row.choice != nullptr && std::ranges::count(choices, row.choice) == 0) choices.push_back(row.choice);
    }
    return choices;
}

std::string buttons_of_kinds() {
    std::string buttons;
    for (const tracking::KindChoice* choice : choices_of_kinds()) {
        buttons += fmt::format("<label><input type=\"radio\" name=\"kind\" value=\"{}\"><span>{}</span></label>\n",
                               choice->name, choice->words);
    }
    return buttons;
}

std::string orders_of_kinds() {
    std::string orders;
    for (const tracking::KindChoice* choice : choices_of_kinds()) {
        orders += fmt::format("<option value=\"{}\">{}</option>", choice->name, choice->order);
    }
    return orders;
}

constexpr int gone_bit = 1 << 8;
constexpr int container_bit = 1 << 10;  // its beginning comes from the container
constexpr int modified_bit = 1 << 11;   // its beginning is its file's time minus its duration

/// What the recording of a clip did, null if nothing.
Json faults_of(const Sidecar& sidecar) {
    if (sidecar.faults.empty()) return sidecar.damaged > 0 ? Json{"damaged"} : Json();
    return sidecar.faults;
}

Json row_of(const Sidecar& sidecar, const Place& place, const std::vector<std::string>& cameras, bool gone) {
    const auto camera = std::ranges::lower_bound(cameras, place.camera) - cameras.begin();
    Json row{camera,
             page::url_of_path(sidecar.clip.path),
             place.begin.utc,
             std::round(sidecar.seconds * 10) / 10,
             or_null(sidecar.events),
             files_of(sidecar) | (gone ? gone_bit : 0) |
                 (place.begin.source == ClockSource::container ? container_bit : 0) |
                 (place.begin.source == ClockSource::modified ? modified_bit : 0),
             tallies_of(sidecar),
             classes_of(sidecar),
             faults_of(sidecar)};
    const bool failed = sidecar.state == Sidecar::State::failed;
    if (failed || sidecar.status != 0) {
        row.push_back(failed ? Json(sidecar.status) : Json());
        row.push_back(sidecar.reason);
    }
    if (failed) {
        row.push_back(sidecar.tries);
        if (sidecar.shows) row.push_back(sidecar.shows->clip.modified / 1'000'000'000);
    }
    return row;
}

/// The time zone of this machine since the first clip: entries [from, seconds ahead of UTC, name]. Years without clips
/// are skipped, because a clip with a wrong time may be all there is.
Json zone_of(const std::vector<Place>& places) {
    constexpr std::int64_t years = 3 * 366 * std::int64_t{86'400};
    std::set<std::int64_t> moments;  // at which clips begin and end
    for (const Place& place : places) {
        const double seconds = std::min(place.seconds, longest_recording);
        moments.insert({place.begin.utc, place.begin.utc + std::llround(seconds)});
    }
    Json zone = Json::array();
    const auto add = [&](const ZoneChange& change) {
        zone.push_back({change.from, change.offset, zone_text(change.from)});
    };
    for (auto begin = moments.begin(); begin != moments.end();) {
        auto end = begin;
        for (auto next = std::next(begin); next != moments.end() && *next - *end < years; ++next) end = next;
        std::ranges::for_each(zone_changes(*begin, *end), add);
        begin = std::next(end);
    }
    return zone;
}

constexpr std::string_view day_file_begin = "index.";
constexpr std::string_view day_file_end = ".js";

}  // namespace

Begin begin_of(const Sidecar& sidecar, const footage::RecorderNames& names) {
    // The time of the file when its outputs were made, because a later attempt doesn't show in them.
    const std::int64_t end = shown_by(sidecar).clip.modified / 1'000'000'000;
    const std::int64_t written = std::clamp<std::int64_t>(end - std::llround(sidecar.seconds), 0, last_time - 1);
    const auto named = sidecar.day ? std::nullopt : names.read(sidecar.clip.path).begin;
    if (named) {
        if (const std::int64_t begin = footage::utc_of(*named, written); can_be_time(begin)) {
            return {begin, ClockSource::file_name};
        }
    }
    if (sidecar.recorded) {
        if (const auto seconds = seconds_of(*sidecar.recorded)) return {*seconds, sidecar.recorded_by};
    }
    return {written, ClockSource::modified};
}

std::string listed_date_of(const Sidecar& sidecar, const footage::RecorderNames& names) {
    return sidecar.day ? sidecar.day->date : date_of(begin_of(sidecar, names).utc);
}

void check_own_index(const std::filesystem::path& out) {
    constexpr std::string_view title = "<title>Video archive</title>";  // as in core/web/index/index.html
    const std::filesystem::path file = out / index_name;
    const int descriptor = open_no_follow(file, O_RDONLY);
    if (descriptor < 0) return;  // there is none, or `check_own_place` refuses it
    std::array<char, 4096> beginning{};
    const ssize_t bytes = ::read(descriptor, beginning.data(), beginning.size());
    ::close(descriptor);
    const std::string_view text(beginning.data(), static_cast<std::size_t>(std::max<ssize_t>(bytes, 0)));
    if (text.empty() || text.find(title) != std::string_view::npos) return;
    throw Error(ErrorCode::file_invalid,
                fmt::format("cannot write '{}': it is another page, which vvr did not write; choose another folder for "
                            "the pictures, or move this page",
                            file.string()));
}

DayFiles make_day_files(const std::vector<Sidecar>& sidecars, const footage::RecorderNames& names) {
    // If clips of a camera's day or night are listed singly, its picture would repeat them.
    std::map<std::string, std::set<std::int64_t>> single;  // begins, by camera
    for (const Sidecar& sidecar : sidecars) {
        if (!sidecar.day) single[names.camera_of(sidecar.clip.path)].insert(begin_of(sidecar, names).utc);
    }
    const auto repeats = [&](const Sidecar& sidecar) {
        if (!sidecar.day) return false;
        const std::int64_t begin = begin_of(sidecar, names).utc;
        const std::set<std::int64_t>& begins = single[sidecar.day->camera];
        const auto next = begins.lower_bound(begin);
        return next != begins.end() && static_cast<double>(*next - begin) <= sidecar.seconds;
    };
    std::map<std::string, Json> days;
    for (const Sidecar& sidecar : sidecars) {
        if (sidecar.found.empty() || repeats(sidecar)) continue;
        Json& day = days[listed_date_of(sidecar, names)];
        day.push_back({page::url_of_path(sidecar.clip.path), list_of(sidecar.found, json_of)});
        if (!sidecar.stills.empty()) day.back().push_back(sidecar.stills);
    }
    DayFiles files;
    for (const auto& [day, clips] : days) {
        files[fmt::format("{}{}{}", day_file_begin, day, day_file_end)] =
            fmt::format("vvrDay(\"{}\",{});\n", day, page::script_json(json_text(clips, -1, true)));
    }
    return files;
}

bool is_day_file(std::string_view name) {
    if (!name.starts_with(day_file_begin) || !name.ends_with(day_file_end)) return false;
    name.remove_prefix(day_file_begin.size());
    return is_date_text(name.substr(0, name.size() - day_file_end.size()));
}

std::string make_index(const std::vector<Sidecar>& sidecars, const footage::RecorderNames& names,
                       const std::set<std::string>& gone) {
    std::vector<Place> places;
    for (const Sidecar& sidecar : sidecars) places.push_back(place_of(sidecar, names));
    std::set<std::string> found;
    for (const Place& place : places) found.insert(place.camera);
    const std::vector<std::string> cameras(found.begin(), found.end());
    Json json{{"cameras", list_of(cameras, text_of_path)},
              {"zone", zone_of(places)},
              {"kinds", page::json_of_kinds()},
              {"classes", classes_by_group(sidecars)},
              {"sheet_columns", page::ContactSheet::columns},
              {"clips", Json::array()},
              {"recordings", Json::array()}};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Json row = row_of(sidecars[i], places[i], cameras, gone.contains(sidecars[i].clip.path));
        if (const auto& day = sidecars[i].day) {
            json["recordings"].push_back(
                {{"date", day->date}, {"night", day->rule.is_night()}, {"clips", day->clips}, {"row", row}});
        } else {
            json["clips"].push_back(row);
        }
    }
    std::set<std::string> days;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!sidecars[i].found.empty()) days.insert(listed_date_of(sidecars[i], names));
    }
    json["days"] = days;
    const std::string style = std::string(web::theme_css) + std::string(web::index_css);
    const std::string script(web::index_js);
    return page::fill(web::index_html, {
                                           {"script policy", page::policy_hash(script)},
                                           {"style policy", page::policy_hash(style)},
                                           {"style", style},
                                           {"kinds", buttons_of_kinds()},
                                           {"orders", orders_of_kinds()},
                                           {"script", script},
                                           {"data", page::script_json(json_text(json, -1, true))},
                                       });
}

}  // namespace vvr::archive
