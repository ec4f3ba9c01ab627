#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "core/archive/found_events.h"
#include "core/archive/output_files.h"
#include "core/archive/sidecar.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/json_text.h"
#include "core/footage/piece_names.h"
#include "core/footage/unseen.h"

// The text of sidecars.
namespace vvr::archive {

namespace {

namespace fs = std::filesystem;

/// Increased when older versions would misread a sidecar; they then treat the clip as new.
constexpr int format_version = 1;

constexpr std::array states{"done", "failed", "outside"};  // as in Sidecar::State

std::string file_name(const std::string& clip) {
    return clip.substr(clip.rfind('/') + 1);
}

/// A sidecar has an impossible number.
class InvalidSidecar : public std::exception {
  public:
    const char* what() const noexcept override { return "a number is out of range"; }
};

std::int64_t whole_number(const Json& json, std::int64_t most = std::numeric_limits<std::int64_t>::max()) {
    if (!json.is_number_integer()) throw InvalidSidecar();
    if (json.is_number_unsigned() ? json.get<std::uint64_t>() > static_cast<std::uint64_t>(most)
                                  : json.get<std::int64_t>() < 0 || json.get<std::int64_t>() > most) {
        throw InvalidSidecar();
    }
    return json.get<std::int64_t>();
}

double number(const Json& json, double most) {
    const auto value = json.get<double>();
    if (!(value >= 0 && value <= most)) throw InvalidSidecar();
    return value;
}

constexpr int most_tries = 1'000'000;
constexpr int highest_status = 255;
constexpr double longest_try = 1e9;

template <class Value>
std::optional<Value> optional_of(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<Value>());
}

std::int64_t modified_of(const Json& json) {
    return whole_number(json, (last_time - 1) * 1'000'000'000);
}

/// "12:00"
std::string text_of_begin(const DayRule& rule) {
    return fmt::format("{:02}:{:02}", rule.begins.count() / 60, rule.begins.count() % 60);
}

/// \param begins null = midnight
DayRule rule_of(const Json& begins) {
    if (begins.is_null()) return {};
    const auto seconds = parse_time_of_day(begins.get<std::string>());
    if (!seconds || *seconds % 60 != 0) throw InvalidSidecar();
    return {std::chrono::minutes(*seconds / 60)};
}

/// Files by folder, {"gate/2026-11-21": ["08.00.mp4", …]}, because most files of a day share one.
Json json_of_files(const std::vector<std::string>& files) {
    Json folders = Json::object();
    for (const std::string& file : files) {
        const auto slash = file.rfind('/');
        const std::string folder = slash == std::string::npos ? "" : file.substr(0, slash);
        folders[text_of_path(folder)].push_back(text_of_path(file_name(file)));
    }
    return folders;
}

std::vector<std::string> files_of(const Json& folders) {
    std::vector<std::string> files;
    for (const auto& [folder, names] : folders.items()) {
        for (const Json& name : names) {
            const std::string path = path_of_text((folder.empty() ? "" : folder + "/") + name.get<std::string>());
            if (!is_plain_path(path)) throw InvalidSidecar();
            files.push_back(path);
        }
    }
    std::ranges::sort(files);
    return files;
}

/// The source of the time of recording. Older sidecars don't name it; it was the container.
ClockSource source_of(const Json& name) {
    const auto row = std::ranges::find_if(clock_sources, [&](const ClockSourceRow& r) { return name == r.name; });
    return row == clock_sources.end() ? ClockSource::container : row->source;
}

std::vector<OutputKind> kinds_of(const Json& files, const std::string& clip) {
    std::vector<OutputKind> kinds;
    for (const OutputRow& row : output_rows) {
        const auto found = files.find(std::string(row.name));
        if (found == files.end()) continue;
        const std::string name = path_of_text(found->get<std::string>());
        // A file of another name is foreign, and is left alone.
        if (is_plain_name(name) && name == file_name(clip) + std::string(row.extension)) kinds.push_back(row.kind);
    }
    return kinds;
}

/// Names that vvr gives no piece are foreign, and are left alone.
std::vector<std::string> pieces_of(const Json& names) {
    std::vector<std::string> pieces;
    for (const Json& name : names) {
        if (footage::is_piece_name(name.get<std::string>())) pieces.push_back(name.get<std::string>());
    }
    return pieces;
}

std::optional<Sidecar> sidecar_of(const std::string& text) {
    const Json json = parse_json(text);
    if (json.at(sidecar_mark) != format_version) return std::nullopt;
    Sidecar sidecar;
    const Json& clip = json.at("clip");
    sidecar.clip = {path_of_text(clip.at("path").get<std::string>()), whole_number(clip.at("bytes")),
                    modified_of(clip.at("modified_ns"))};
    if (!is_plain_path(sidecar.clip.path)) return std::nullopt;
    sidecar.version = json.at("vvr").get<std::string>();
    sidecar.settings = json.at("settings").get<std::string>();
    const auto* const state = std::ranges::find(states, json.at("state").get<std::string>());
    sidecar.state =
        state == states.end() ? Sidecar::State::failed : static_cast<Sidecar::State>(state - states.begin());
    sidecar.tries = static_cast<int>(whole_number(json.at("tries"), most_tries));
    sidecar.status = static_cast<int>(whole_number(json.at("status"), highest_status));
    if (const Json code = json.value("code", Json()); code.is_string()) {
        sidecar.code = find_error_code(code.get<std::string>());
    }
    sidecar.reason = optional_of<std::string>(json.at("reason")).value_or("");
    sidecar.took = number(json.at("took_seconds"), longest_try);
    if (const auto limits = json.find("limits"); limits != json.end())
        sidecar.limits = {whole_number(limits->at("seconds")), whole_number(limits->at("memory"))};
    sidecar.files = kinds_of(json.at("files"), sidecar.clip.path);
    sidecar.pieces = pieces_of(json.value("pieces", Json::array()));
    if (const auto day = json.find("day"); day != json.end()) {
        sidecar.day = Sidecar::Day{path_of_text(day->at("camera").get<std::string>()),
                                   day->at("date").get<std::string>(), whole_number(day->at("clips"))};
        if (!is_date_text(sidecar.day->date)) throw InvalidSidecar();
        sidecar.day->rule = rule_of(day->value("begins", Json()));
        sidecar.day->rule.by_container = day->value("by_container", false);
        sidecar.day->unread = files_of(day->value("unread", Json::object()));
        if (const auto files = json.find("clips"); files != json.end()) sidecar.day->files = files_of(*files);
    }
    if (const auto shown = json.find("shows"); shown != json.end() && sidecar.state == Sidecar::State::failed) {
        sidecar.shows = {{sidecar.clip.path, whole_number(shown->at("bytes")), modified_of(shown->at("modified_ns"))},
                         shown->at("settings").get<std::string>()};
    }
    if (sidecar.state != Sidecar::State::done && !sidecar.shows) return sidecar;
    sidecar.frames = whole_number(json.at("frames"));
    sidecar.damaged = whole_number(json.at("damaged"));
    sidecar.faults = json.value("faults", std::vector<std::string>());
    sidecar.seconds = number(json.at("seconds"), longest_recording);
    if (const Json& events = json.at("events"); !events.is_null()) sidecar.events = whole_number(events);
    sidecar.recorded = optional_of<std::string>(json.at("recorded"));
    sidecar.recorded_by = source_of(json.value("recorded_by", Json()));
    // Older sidecars have none.
    for (const Json& event : json.value("found", Json::array())) sidecar.found.push_back(found_event_of(event));
    for (const Json& still : json.value("stills", Json::array())) sidecar.stills.push_back(whole(still.get<double>()));
    return sidecar;
}

/// A JSON value with each element on its own line.
std::string in_lines(const Json& json) {
    std::string text = json.is_object() ? "{" : "[";
    const char* separator = "\n    ";
    for (const auto& [name, part] : json.items()) {
        text += separator;
        if (json.is_object()) text += json_text(Json(name)) + ": ";
        text += json_text(part);
        separator = ",\n    ";
    }
    return text + (json.empty() ? "" : "\n  ") + (json.is_object() ? "}" : "]");
}

/// JSON text in lines for people, with each event, and the clips of each folder of a day, on one line.
std::string text_of(Json json) {
    std::string lists;
    for (const char* name : {"clips", "found", "stills", "pieces"}) {
        if (const auto list = json.find(name); list != json.end()) {
            lists += fmt::format(",\n  \"{}\": {}", name, in_lines(*list));
            json.erase(name);
        }
    }
    std::string text = json_text(json, 2);
    text.resize(text.rfind('\n'));
    return text + lists + "\n}\n";
}

}  // namespace

std::string format_sidecar(const Sidecar& sidecar) {
    const bool done = sidecar.state == Sidecar::State::done;
    Json json{{sidecar_mark, format_version},
              {"vvr", sidecar.version},
              {"clip",
               {{"path", text_of_path(sidecar.clip.path)},
                {"bytes", sidecar.clip.size},
                {"modified_ns", sidecar.clip.modified}}},
              {"settings", sidecar.settings},
              {"state", states[static_cast<std::size_t>(sidecar.state)]},
              {"tries", sidecar.tries},
              {"status", sidecar.status},
              {"code", sidecar.code ? Json(row_of(*sidecar.code).name) : Json()},
              {"reason", or_null(sidecar.reason)},
              {"took_seconds", sidecar.took}};
    if (sidecar.limits) json["limits"] = {{"seconds", sidecar.limits->seconds}, {"memory", sidecar.limits->memory}};
    if (sidecar.day) {
        json["day"] = {
            {"camera", text_of_path(sidecar.day->camera)}, {"date", sidecar.day->date}, {"clips", sidecar.day->clips}};
        // Older versions know no other beginning than midnight.
        if (sidecar.day->rule.begins != DayRule().begins) json["day"]["begins"] = text_of_begin(sidecar.day->rule);
        if (sidecar.day->rule.by_container) json["day"]["by_container"] = true;
        if (!sidecar.day->unread.empty()) json["day"]["unread"] = json_of_files(sidecar.day->unread);
        if (!sidecar.day->files.empty()) json["clips"] = json_of_files(sidecar.day->files);
    }
    if (sidecar.shows) {
        json["shows"] = {{"bytes", sidecar.shows->clip.size},
                         {"modified_ns", sidecar.shows->clip.modified},
                         {"settings", sidecar.shows->settings}};
    }
    if (done || sidecar.shows) {
        json["frames"] = sidecar.frames;
        json["damaged"] = sidecar.damaged;
        if (!sidecar.faults.empty()) json["faults"] = sidecar.faults;
        json["seconds"] = sidecar.seconds;
        json["events"] = or_null(sidecar.events);
        json["recorded"] = or_null(sidecar.recorded);
        json["recorded_by"] = sidecar.recorded ? Json(row_of(sidecar.recorded_by).name) : Json();
        json["found"] = list_of(sidecar.found, json_of);
        if (!sidecar.stills.empty()) json["stills"] = sidecar.stills;
    }
    json["files"] = Json::object();
    for (const OutputKind kind : sidecar.files) {
        const auto row = std::ranges::find(output_rows, kind, &OutputRow::kind);
        json["files"][std::string(row->name)] =
            text_of_path(file_name(sidecar.clip.path)) + std::string(row->extension);
    }
    if (!sidecar.pieces.empty()) json["pieces"] = sidecar.pieces;
    return text_of(json);
}

std::optional<Sidecar> parse_sidecar(const std::string& text) {
    try {
        return sidecar_of(text);
    } catch (const Json::exception&) {
        return std::nullopt;
    } catch (const InvalidSidecar&) {
        return std::nullopt;
    } catch (const Error&) {
        return std::nullopt;
    }
}

namespace {

/// Summarizes the problems of a day in one line: a few of them, and the number of the others.
std::string problems_of(const Json& problems) {
    constexpr std::size_t most = 3;
    std::string text;
    for (std::size_t i = 0; i < std::min(problems.size(), most); ++i) {
        text += (i == 0 ? "" : "; ") + problems[i].get<std::string>();
    }
    if (problems.size() > most) text += fmt::format("; and {} more, in its report", problems.size() - most);
    return text;
}

}  // namespace

void apply_report(Sidecar& sidecar, const fs::path& report) {
    const auto refuse = [&](const std::string& why) {
        throw Error(
            ErrorCode::worker_result_invalid,
            fmt::format("cannot read the report '{}' of a worker: {}; draw the clip again", report.string(), why));
    };
    try {
        const OwnText own = read_own(report, "{", largest_report);
        if (!own.problem.empty()) refuse(own.problem);
        const Json json = parse_json(own.text.value_or(""));
        sidecar.frames = whole_number(json.at("frames").at("used"));
        sidecar.damaged = whole_number(json.at("frames").at("damaged"));
        sidecar.faults = footage::faults_from(json.at("unseen"));
        sidecar.seconds = json.at("span").at("seconds").get<double>();
        sidecar.recorded = optional_of<std::string>(json.at("input").at("recorded"));
        sidecar.recorded_by = source_of(json.at("input").at("recorded_by"));
        if (sidecar.day && sidecar.reason.empty()) sidecar.reason = problems_of(json.at("problems"));
        if (const std::string not_kept = json.value("not_kept", ""); !not_kept.empty()) {
            sidecar.reason += (sidecar.reason.empty() ? "" : "; ") + not_kept;
            const auto code = find_error_code(json.value("not_kept_code", ""));
            if (code && row_of(*code).kind == ErrorKind::io) sidecar.code = code;
            if (!sidecar.code) sidecar.code = ErrorCode::partial;
        }
        // The index must place every clip, and names the source of the time.
        if (!sidecar.recorded) sidecar.recorded = optional_of<std::string>(json.at("input").at("written"));
        if (const Json& events = json.at("events"); !events.is_null()) {
            sidecar.events = static_cast<std::int64_t>(events.size());
            sidecar.found = found_events(json);
        }
        for (const Json& seconds : json.value("stills", Json::array())) {
            sidecar.stills.push_back(whole(10 * seconds.get<double>()));
        }
    } catch (const Json::exception& error) {
        refuse(error.what());
    } catch (const InvalidSidecar& error) {
        refuse(error.what());
    } catch (const Error& error) {
        refuse(error.what());
    }
    if (sidecar.seconds >= 0 && sidecar.seconds <= longest_recording) return;
    sidecar.reason =
        fmt::format("its times give an impossible length of {:.3g} s; the length is left out", sidecar.seconds);
    sidecar.seconds = 0;
}

}  // namespace vvr::archive
