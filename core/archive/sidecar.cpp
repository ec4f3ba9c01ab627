#include "core/archive/sidecar.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/image/atomic_file.h"
#include "core/json_text.h"
#include "core/plain_name.h"

namespace vvr {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Raised when older versions would misread a sidecar; they then treat the clip as new.
constexpr int format_version = 1;
constexpr const char* mark = "vvr-archive";

std::string file_name(const std::string& clip) {
    return clip.substr(clip.rfind('/') + 1);
}

/// All of a file, if it begins with `beginning`. Other JSON files are not read: they may be large and many.
std::optional<std::string> text_of_file(const fs::path& path, std::string_view beginning) {
    std::ifstream file(path, std::ios::binary);
    std::string text(beginning.size(), 0);
    if (!file.read(text.data(), static_cast<std::streamsize>(text.size())) || text != beginning) return std::nullopt;
    return text.append(std::istreambuf_iterator<char>(file), {});
}

template <class Value>
Json json_of(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

template <class Value>
std::optional<Value> optional_of(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<Value>());
}

std::vector<OutputKind> kinds_of(const Json& files, const std::string& clip) {
    std::vector<OutputKind> kinds;
    for (const OutputRow& row : output_rows) {
        const auto found = files.find(std::string(row.name));
        if (found == files.end()) continue;
        const std::string name = path_of_text(found->get<std::string>());
        // A file of another name is not ours, and is not touched.
        if (is_plain_name(name) && name == file_name(clip) + std::string(row.ending)) kinds.push_back(row.kind);
    }
    return kinds;
}

std::optional<Sidecar> sidecar_of(const std::string& text) {
    const Json json = parse_json(text);
    if (json.at(mark) != format_version) return std::nullopt;
    Sidecar sidecar;
    const Json& clip = json.at("clip");
    sidecar.clip = {path_of_text(clip.at("path").get<std::string>()), clip.at("bytes").get<std::int64_t>(),
                    clip.at("modified_ns").get<std::int64_t>()};
    if (!is_plain_path(sidecar.clip.path)) return std::nullopt;
    sidecar.version = json.at("vvr").get<std::string>();
    sidecar.settings = json.at("settings").get<std::string>();
    sidecar.state = json.at("state") == "done" ? Sidecar::State::done : Sidecar::State::failed;
    sidecar.tries = json.at("tries").get<int>();
    sidecar.status = json.at("status").get<int>();
    sidecar.reason = optional_of<std::string>(json.at("reason")).value_or("");
    sidecar.took = json.at("took_seconds").get<double>();
    sidecar.files = kinds_of(json.at("files"), sidecar.clip.path);
    if (const auto day = json.find("day"); day != json.end()) {
        sidecar.day = Sidecar::Day{path_of_text(day->at("camera").get<std::string>()),
                                   day->at("date").get<std::string>(), day->at("clips").get<std::int64_t>()};
    }
    if (sidecar.state == Sidecar::State::failed) return sidecar;
    sidecar.frames = json.at("frames").get<std::int64_t>();
    sidecar.damaged = json.at("damaged").get<std::int64_t>();
    sidecar.seconds = json.at("seconds").get<double>();
    sidecar.events = optional_of<std::int64_t>(json.at("events"));
    sidecar.recorded = optional_of<std::string>(json.at("recorded"));
    // Older sidecars have none.
    for (const Json& event : json.value("found", Json::array())) sidecar.found.push_back(found_event_of(event));
    return sidecar;
}

/// Over lines for people, but each event in one.
std::string text_of(Json json) {
    const Json found = json.value("found", Json());
    json.erase("found");
    std::string text = json_text(json, 2);
    if (found.is_null()) return text + "\n";
    text.resize(text.rfind('\n'));
    text += ",\n  \"found\": [";
    for (const Json& event : found) text += (&event == &found.front() ? "\n    " : ",\n    ") + json_text(event);
    return text + (found.empty() ? "]" : "\n  ]") + "\n}\n";
}

}  // namespace

std::string format_sidecar(const Sidecar& sidecar) {
    const bool done = sidecar.state == Sidecar::State::done;
    Json json{{mark, format_version},
              {"vvr", sidecar.version},
              {"clip",
               {{"path", text_of_path(sidecar.clip.path)},
                {"bytes", sidecar.clip.size},
                {"modified_ns", sidecar.clip.modified}}},
              {"settings", sidecar.settings},
              {"state", done ? "done" : "failed"},
              {"tries", sidecar.tries},
              {"status", sidecar.status},
              {"reason", sidecar.reason.empty() ? Json() : Json(sidecar.reason)},
              {"took_seconds", sidecar.took}};
    if (sidecar.day) {
        json["day"] = {
            {"camera", text_of_path(sidecar.day->camera)}, {"date", sidecar.day->date}, {"clips", sidecar.day->clips}};
    }
    if (done) {
        json["frames"] = sidecar.frames;
        json["damaged"] = sidecar.damaged;
        json["seconds"] = sidecar.seconds;
        json["events"] = json_of(sidecar.events);
        json["recorded"] = json_of(sidecar.recorded);
        json["found"] = Json::array();
        for (const FoundEvent& event : sidecar.found) json["found"].push_back(json_of(event));
    }
    json["files"] = Json::object();
    for (const OutputKind kind : sidecar.files) {
        const auto row = std::ranges::find(output_rows, kind, &OutputRow::kind);
        json["files"][std::string(row->name)] = text_of_path(file_name(sidecar.clip.path)) + std::string(row->ending);
    }
    return text_of(json);
}

std::optional<Sidecar> parse_sidecar(const std::string& text) {
    try {
        return sidecar_of(text);
    } catch (const Json::exception&) {
        return std::nullopt;
    }
}

void write_sidecar(const fs::path& out, const Sidecar& sidecar) {
    const std::string text = format_sidecar(sidecar);
    replace_file(sidecar_path(out, sidecar.clip.path), std::as_bytes(std::span(text)));
}

std::optional<Sidecar> read_sidecar(const fs::path& out, const std::string& clip) {
    return read_sidecar_file(out, sidecar_path("", clip).string());
}

std::optional<Sidecar> read_sidecar_file(const fs::path& out, const std::string& file) {
    const std::optional<std::string> text = text_of_file(out / file, fmt::format("{{\n  \"{}\"", mark));
    if (!text) return std::nullopt;
    std::optional<Sidecar> sidecar = parse_sidecar(*text);
    return sidecar && sidecar_path("", sidecar->clip.path).string() == file ? sidecar : std::nullopt;
}

void take_report(Sidecar& sidecar, const fs::path& report) {
    try {
        const Json json = parse_json(text_of_file(report, "{").value_or(""));
        sidecar.frames = json.at("frames").at("used").get<std::int64_t>();
        sidecar.damaged = json.at("frames").at("damaged").get<std::int64_t>();
        sidecar.seconds = json.at("span").at("seconds").get<double>();
        sidecar.recorded = optional_of<std::string>(json.at("input").at("recorded"));
        if (const Json& events = json.at("events"); !events.is_null()) {
            sidecar.events = static_cast<std::int64_t>(events.size());
            sidecar.found = found_events(json);
        }
    } catch (const Json::exception& error) {
        throw Error(ErrorKind::io, fmt::format("cannot read the report '{}' that vvr render wrote: {}", report.string(),
                                               error.what()));
    }
}

void remove_outputs(const fs::path& out, const Sidecar& sidecar) {
    std::vector<fs::path> files;
    for (const OutputKind kind : sidecar.files) files.push_back(output_path(out, sidecar.clip.path, kind));
    files.push_back(sidecar_path(out, sidecar.clip.path));
    for (const fs::path& file : files) {
        std::error_code error;
        fs::remove(file, error);
        if (error) {
            throw Error(ErrorKind::io, fmt::format("cannot remove '{}': {}; fix the permissions of its folder",
                                                   file.string(), error.message()));
        }
    }
}

}  // namespace vvr
