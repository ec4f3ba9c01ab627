#include "cli/render/event_times.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json_text.h"
#include "core/read_file.h"

namespace vvr {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::filesystem::path& report, const std::string& what) {
    throw Error(
        ErrorKind::usage,
        fmt::format("report '{}' {}; make one with: vvr render CLIP --report report.json", report.string(), what),
        {"report"});
}

}  // namespace

ReportedEvents read_events(const std::filesystem::path& report) {
    const Json json = parse_json(read_file(report.string()));
    if (!json.is_object() || !json.contains("report") || !json.contains("events")) {
        refuse(report, "is no report of `vvr render`");
    }
    if (!json["events"].is_array()) refuse(report, "tells of no events, as they were not searched for");
    try {
        ReportedEvents events{json.at("input").at("name").get<std::string>(), {}};
        for (const Json& event : json["events"]) {
            events.times.push_back(
                {event.at("first").at("seconds").get<double>(), event.at("last").at("seconds").get<double>()});
        }
        return events;
    } catch (const Json::exception&) {
        refuse(report, "is not as `vvr render` writes it");
    }
}

}  // namespace vvr
