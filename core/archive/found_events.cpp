#include "core/archive/found_events.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/json_text.h"

namespace vvr::archive {

namespace {

constexpr std::size_t before_path = 3;

tracking::EventKind kind_of(const std::string& name) {
    const auto row = std::ranges::find(tracking::event_kinds, name, &tracking::EventKindRow::name);
    if (row == tracking::event_kinds.end())
        throw Error(ErrorCode::file_invalid, fmt::format("the kind of event '{}' is unknown", name));
    return row->kind;
}

/// \throws Error io for an unknown class
const detector::ObjectClass* class_of(const std::string& name) {
    if (const detector::ObjectClass* const found = detector::find_class(name)) return found;
    throw Error(ErrorCode::file_invalid, fmt::format("the class of objects '{}' is unknown", name));
}

int whole_of(const Json& json) {
    return whole(json.get<double>());
}

FoundEvent event_of(const Json& event, double width, double height) {
    FoundEvent found;
    found.kind = kind_of(event.at("kind").get<std::string>());
    found.number = whole_of(event.at("number"));
    double still = 0;
    for (const Json& stay : event.at("stays")) still += stay.at("seconds").get<double>();
    found.still = whole(still * 10);
    std::vector<tracking::Waypoint> way;
    for (const Json& point : event.at("path")) {
        const Json& place = point.at("place");
        way.push_back(tracking::waypoint(point.at("seconds").get<double>(),
                                         {place.at("x").get<double>(), place.at("y").get<double>()}, {width, height}));
    }
    found.path = tracking::simplified(way);
    // Older reports have no class.
    if (const auto what = event.find("class"); what != event.end() && !what->is_null()) {
        found.what = class_of(what->get<std::string>());
    }
    return found;
}

}  // namespace

int whole(double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e8, 1e8)));
}

int length_of(const FoundEvent& event) {
    return event.path.empty() ? 0 : event.path.back().time - event.path.front().time;
}

std::vector<FoundEvent> found_events(const Json& report, std::size_t most) {
    const Json& events = report.at("events");
    const double width = std::max(1.0, report.at("input").at("width").get<double>());
    const double height = std::max(1.0, report.at("input").at("height").get<double>());
    std::vector<FoundEvent> found;
    for (const Json& event : events) found.push_back(event_of(event, width, height));
    if (found.size() <= most) return found;
    std::ranges::stable_sort(found, std::greater(), length_of);
    found.resize(most);
    std::ranges::sort(found, {}, &FoundEvent::number);
    return found;
}

Json json_of(const FoundEvent& event) {
    Json json{tracking::name_of(event.kind), event.number, event.still};
    for (const tracking::Waypoint& point : event.path) {
        for (const int value : {point.time, point.x, point.y}) json.push_back(value);
    }
    if (event.what != nullptr) json.push_back(event.what->name);
    return json;
}

FoundEvent found_event_of(const Json& json) {
    FoundEvent event;
    event.kind = kind_of(json.at(0).get<std::string>());
    event.number = whole_of(json.at(1));
    event.still = whole_of(json.at(2));
    for (std::size_t k = before_path; k + 2 < json.size(); k += 3) {
        event.path.push_back({whole_of(json.at(k)), whole_of(json.at(k + 1)), whole_of(json.at(k + 2))});
    }
    if (json.back().is_string() && json.size() > before_path) event.what = class_of(json.back().get<std::string>());
    return event;
}

}  // namespace vvr::archive
