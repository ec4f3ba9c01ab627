#include "core/archive/event_lines.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/archive/output_files.h"
#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/condition/condition.h"
#include "core/detector/classes.h"
#include "core/tracking/event_kind.h"
#include "core/tracking/event_line.h"
#include "core/tracking/path.h"

namespace vvr::archive {

namespace {

namespace fs = std::filesystem;
/// A worker wrote the report, and a malicious clip may have taken it over: everything is checked.
Json parsed(const fs::path& report) {
    return parse_json(read_own(report, "{", largest_report).text.value_or(""));
}

std::optional<std::string> time_of(const Json& moment) {
    constexpr std::size_t longest = 40;  // "2026-11-21T08:00:07+01:00" and a fraction
    const auto time = moment.find("time");
    if (time == moment.end() || !time->is_string() || time->get_ref<const std::string&>().size() > longest) return {};
    return time->get<std::string>();
}

std::string file_of(const Json& moment) {
    const auto file = moment.find("file");
    return file == moment.end() ? std::string() : file->get<std::string>();
}

/// The file of a recording that has only one, or of a clip.
std::string only_file_of(const Json& report) {
    return report.at("input").at("name").get<std::string>();
}

/// \throws Error io for anything but a whole number that a picture or a list of events can have
int count_of(const Json& json) {
    constexpr std::int64_t most = 1'000'000;
    if (json.is_number_integer()) {
        const auto number = json.get<std::int64_t>();
        if (number >= 0 && number <= most) return static_cast<int>(number);
    }
    throw Error(ErrorCode::worker_result_invalid, "a number of an event in the report of a worker is out of range");
}

PixelBox box_of(const Json& box) {
    const int left = count_of(box.at("x"));
    const int top = count_of(box.at("y"));
    return {left, top, left + count_of(box.at("width")), top + count_of(box.at("height"))};
}

tracking::EventLine line_of_time(const Json& first, const Json& last) {
    tracking::EventLine line;
    line.first = first.at("seconds").get<double>();
    line.last = last.at("seconds").get<double>();
    line.begin = time_of(first);
    line.end = time_of(last);
    line.clip = file_of(first);
    return line;
}

tracking::EventLine line_of_interval(const Json& interval) {
    tracking::EventLine line = line_of_time(interval.at("begin"), interval.at("end"));
    const auto name = interval.at("kind").get<std::string>();
    const auto row = std::ranges::find(condition::condition_rows, name, &condition::ConditionRow::name);
    if (row == condition::condition_rows.end())
        throw Error(ErrorCode::worker_result_invalid, fmt::format("there is no condition '{}'", name));
    line.kind = row->name;
    return line;
}

tracking::EventLine line_of(const Json& event) {
    tracking::EventLine line = line_of_time(event.at("first"), event.at("last"));
    const auto name = event.at("kind").get<std::string>();
    const auto kind = std::ranges::find(tracking::event_kinds, name, &tracking::EventKindRow::name);
    if (kind == tracking::event_kinds.end())
        throw Error(ErrorCode::worker_result_invalid, fmt::format("there is no kind of event '{}'", name));
    line.kind = kind->name;
    line.number = static_cast<std::size_t>(count_of(event.at("number")));
    line.open_ended = event.value("open_ended", false);  // older reports lack it
    line.box = box_of(event.at("box"));
    if (const Json& what = event.at("class"); !what.is_null())
        line.what = detector::find_class(what.get<std::string>());
    if (const Json& direction = event.at("direction"); !direction.is_null()) {
        const tracking::Heading* const heading = tracking::find_heading(direction.get<std::string>());
        if (heading != nullptr) line.direction = heading->name;
    }
    return line;
}

}  // namespace

OlderReport read_older_report(const fs::path& report) {
    try {
        const Json json = parsed(report);
        OlderReport older{true, json.at("span").at("last").get<double>()};
        for (const Json& segment : json.at("segments")) older.files.insert(segment.at("file").get<std::string>());
        if (older.files.empty()) older.files.insert(only_file_of(json));
        return older;
    } catch (const Json::exception&) {
        return {};
    }
}

std::vector<tracking::EventLine> new_events(const fs::path& report, const OlderReport& older, Reported about) {
    try {
        const Json json = parsed(report);
        std::vector<tracking::EventLine> lines;
        const auto add = [&](tracking::EventLine line) {
            if (line.clip.empty()) line.clip = only_file_of(json);
            const bool is_old = about == Reported::clip ? line.first <= older.end : older.files.contains(line.clip);
            if (!older.exists || !is_old) lines.push_back(std::move(line));
        };
        for (const Json& event : json.at("events")) add(line_of(event));
        for (const Json& interval : json.at("unseen").at("intervals")) add(line_of_interval(interval));
        return lines;
    } catch (const Json::exception& error) {
        throw Error(ErrorCode::worker_result_invalid,
                    fmt::format("cannot read the events in the report '{}' of a worker: {}; draw the clip again",
                                report.string(), error.what()));
    }
}

std::string table_lines_of(const fs::path& out, const Sidecar& sidecar, const footage::RecorderNames& names) {
    const std::string& path = sidecar.clip.path;
    const fs::path file = output_path(out, path, OutputKind::report);
    tracking::TableClip place;
    place.camera = text_of_path(sidecar.day ? sidecar.day->camera : names.camera_of(path));
    place.clip = text_of_path(path);
    // A report names files as the run was given them.
    place.file_of = [&](const std::string& name) {
        if (!sidecar.day) return place.clip;
        const auto& files = sidecar.day->files;
        const auto found =
            std::ranges::find_if(files, [&](const std::string& one) { return name.ends_with("/" + one); });
        return text_of_path(found == files.end() ? name : *found);
    };
    try {
        const Json report = parsed(file);
        if (report.at("events").is_null()) return {};
        const std::string lines = tracking::events_table_lines(report, place);
        return lines.empty() ? tracking::empty_table_line(place, sidecar.day ? "" : place.clip) : lines;
    } catch (const Json::exception& error) {
        throw Error(ErrorCode::file_invalid,
                    fmt::format("cannot read the events in '{}': {}; remove '{}' to draw it again", file.string(),
                                error.what(), sidecar_path(out, path).string()));
    }
}

}  // namespace vvr::archive
