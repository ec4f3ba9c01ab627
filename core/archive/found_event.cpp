#include "core/archive/found_event.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <nlohmann/json.hpp>

namespace vvr::archive {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kinds = "mslt";
constexpr std::size_t before_path = 3;

/// The first letter of a kind; of one that is not known, that of what moved.
char kind_of(const std::string& name) {
    return !name.empty() && kinds.find(name.front()) != std::string_view::npos ? name.front() : 'm';
}

int whole(double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e8, 1e8)));
}

/// A number that somebody wrote, as near as an int comes to it.
int whole(const Json& json) {
    return whole(json.get<double>());
}

int tenths_of(double seconds) {
    return static_cast<int>(std::lround(std::clamp(seconds * 10, -1e8, 1e8)));
}

FoundEvent event_of(const Json& event, double width, double height) {
    FoundEvent found;
    found.kind = kind_of(event.at("kind").get<std::string>());
    found.number = whole(event.at("number"));
    double still = 0;
    for (const Json& stay : event.at("stays")) still += stay.at("seconds").get<double>();
    found.still = tenths_of(still);
    std::vector<events::Waypoint> way;
    for (const Json& point : event.at("path")) {
        const Json& place = point.at("place");
        way.push_back(events::waypoint(point.at("seconds").get<double>(),
                                        {place.at("x").get<double>(), place.at("y").get<double>()}, {width, height}));
    }
    found.path = events::simplified(way);
    return found;
}

int length_of(const FoundEvent& event) {
    return event.path.empty() ? 0 : event.path.back().time - event.path.front().time;
}

}  // namespace

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
    Json json{std::string(1, event.kind), event.number, event.still};
    for (const events::Waypoint& point : event.path) {
        for (const int value : {point.time, point.x, point.y}) json.push_back(value);
    }
    return json;
}

FoundEvent found_event_of(const Json& json) {
    FoundEvent event;
    event.kind = kind_of(json.at(0).get<std::string>());
    event.number = whole(json.at(1));
    event.still = whole(json.at(2));
    for (std::size_t k = before_path; k + 2 < json.size(); k += 3) {
        event.path.push_back({whole(json.at(k)), whole(json.at(k + 1)), whole(json.at(k + 2))});
    }
    return event;
}

}  // namespace vvr::archive
