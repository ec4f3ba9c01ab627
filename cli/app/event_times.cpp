#include "cli/app/event_times.h"

#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/read_file.h"

namespace vvr::app {

namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse(const std::filesystem::path& report, const std::string& what) {
    throw Error(
        ErrorKind::usage,
        fmt::format("report '{}' {}; make one with: vvr render CLIP --report report.json", report.string(), what),
        {"report"});
}

ReportedFile file_of(const Json& json, const std::string& path, double begin, double end) {
    return {{path, begin, end, 0}, {json.at("bytes").get<std::int64_t>(), json.at("digest").get<std::string>()}};
}

/// The files whose size and digest are known: of a stream, or of pictures, nothing is.
std::vector<ReportedFile> files_of(const Json& report) {
    std::vector<ReportedFile> files;
    const auto is_known = [](const Json& json) { return json.contains("digest") && json["digest"].is_string(); };
    const Json& input = report.at("input");
    constexpr double endless = std::numeric_limits<double>::infinity();
    if (is_known(input)) files.push_back(file_of(input, input.at("name").get<std::string>(), 0, endless));
    if (!report.contains("segments") || !report["segments"].is_array()) return files;
    for (const Json& segment : report["segments"]) {
        if (!is_known(segment)) continue;
        files.push_back(file_of(segment, segment.at("file").get<std::string>(), segment.at("first").get<double>(),
                                segment.at("end").get<double>()));
    }
    return files;
}

}  // namespace

ReportedEvents read_events(const std::filesystem::path& report) {
    const Json json = parse_json(read_file(report.string()));
    if (!json.is_object() || !json.contains("report") || !json.contains("events")) {
        refuse(report, "is no report of `vvr render`");
    }
    if (!json["events"].is_array()) refuse(report, "tells of no events, as they were not searched for");
    try {
        ReportedEvents events{files_of(json), {}};
        for (const Json& event : json["events"]) {
            events.times.push_back(
                {event.at("first").at("seconds").get<double>(), event.at("last").at("seconds").get<double>()});
        }
        if (events.files.empty())
            refuse(report, "does not tell its files' sizes and digests: an older vvr made it, or it is about no file");
        return events;
    } catch (const Json::exception&) {
        refuse(report, "is not as `vvr render` writes it");
    }
}

}  // namespace vvr::app
