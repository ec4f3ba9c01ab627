#include "core/tracking/event_line.h"

#include <array>

#include <fmt/format.h>

#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/tracking/path.h"

namespace vvr::tracking {

std::string_view direction_of(const Event& event) {
    // Nobody saw an event with evidence come or go.
    if (event.evidence || event.path.size() < 2 || !(event.path_length > 0)) return {};
    return heading_of(event.path, event.path_length).name;
}

std::string format_event_line(const EventLine& line) {
    constexpr std::string_view here = "./";  // of relative URLs, which programs put behind an address
    const std::string_view page = line.page;
    const Json json{{"camera", or_null(line.camera)},
                    {"clip", line.clip},
                    {"number", line.number > 0 ? Json(line.number) : Json()},
                    {"kind", line.kind},
                    {"class", line.what != nullptr ? Json(line.what->name) : Json()},
                    {"begin", or_null(line.begin)},
                    {"end", or_null(line.end)},
                    {"first", rounded(line.first)},
                    {"last", rounded(line.last)},
                    {"seconds", rounded(line.last - line.first)},
                    {"open_ended", line.open_ended},
                    {"box", line.number > 0 ? json_of_box(line.box) : Json()},
                    {"direction", or_null(line.direction)},
                    {"page", or_null(page.starts_with(here) ? page.substr(here.size()) : page)}};
    return json_text(json) + "\n";
}

namespace {

/// A column, and where its value is in a report's event.
struct TableColumn {
    std::string_view name;
    const char* place;
};

constexpr std::array columns{TableColumn{"number", "/number"},
                             TableColumn{"kind", "/kind"},
                             TableColumn{"class", "/class"},
                             TableColumn{"score", "/score"},
                             TableColumn{"begin", "/first/time"},
                             TableColumn{"end", "/last/time"},
                             TableColumn{"first_frame", "/first/frame"},
                             TableColumn{"last_frame", "/last/frame"},
                             TableColumn{"first", "/first/seconds"},
                             TableColumn{"last", "/last/seconds"},
                             TableColumn{"seconds", "/seconds"},
                             TableColumn{"still", "/still"},
                             TableColumn{"x", "/box/x"},
                             TableColumn{"y", "/box/y"},
                             TableColumn{"width", "/box/width"},
                             TableColumn{"height", "/box/height"},
                             TableColumn{"direction", "/direction"},
                             TableColumn{"path_length", "/path_length"},
                             TableColumn{"from", "/from"},
                             TableColumn{"into", "/into"},
                             TableColumn{"by", "/by"},
                             TableColumn{"open_ended", "/open_ended"}};

/// A value as RFC 4180 wants it: quoted if it must be.
std::string table_value(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted(1, '"');
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted.append(1, '"');
}

std::string table_value(const Json& value) {
    if (value.is_null()) return {};
    if (value.is_string()) return table_value(value.get<std::string>());
    if (value.is_number_float()) return fmt::format("{:.3f}", value.get<double>());
    return table_value(value.dump());
}

std::string clip_columns(const TableClip& place, const std::string& file) {
    return fmt::format("{},{},{},", table_value(place.camera), table_value(place.clip), table_value(file));
}

}  // namespace

std::string events_table_heading() {
    std::string line = "camera,clip,file,offset";
    for (const TableColumn& column : columns) line += fmt::format(",{}", column.name);
    return line + '\n';
}

std::string events_table_lines(const Json& report, const TableClip& place) {
    std::string lines;
    const auto add = [&](const Json& event) {
        const Json& first = event.at("first");
        const std::string file = first.value("file", report.at("input").at("name").get<std::string>());
        lines += clip_columns(place, place.file_of ? place.file_of(file) : file);
        lines += table_value(first.contains("offset") ? first.at("offset") : first.at("seconds"));
        for (const TableColumn& column : columns)
            lines.append(1, ',').append(table_value(event.value(Json::json_pointer(column.place), Json())));
        lines += '\n';
    };
    for (Json event : report.at("events")) {
        double still = 0;
        for (const Json& stay : event.at("stays")) still += stay.at("seconds").get<double>();
        event["still"] = still;
        add(event);
    }
    for (const Json& interval : report.at("unseen").value("intervals", Json::array())) {
        const Json& begin = interval.at("begin");
        const Json& end = interval.at("end");
        const double seconds = end.at("seconds").get<double>() - begin.at("seconds").get<double>();
        add({{"kind", interval.at("kind")}, {"first", begin}, {"last", end}, {"seconds", seconds}});
    }
    return lines;
}

std::string empty_table_line(const TableClip& place, const std::string& file) {
    return clip_columns(place, file) + std::string(columns.size(), ',') + '\n';
}

}  // namespace vvr::tracking
