#include "core/archive/found_event.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <nlohmann/json.hpp>

namespace vvr {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kinds = "mslt";
constexpr double path_tolerance = 12;  // thousandths of the picture: less than a person's width in most scenes
constexpr std::size_t before_path = 3;

/// The first letter of a kind; of one that is not known, that of what moved.
char kind_of(const std::string& name) {
    return !name.empty() && kinds.find(name.front()) != std::string_view::npos ? name.front() : 'm';
}

int whole(double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e8, 1e8)));
}

/// How far a point is from where the straight way from `a` to `b` has it at its moment.
double off_way(const FoundPoint& a, const FoundPoint& b, const FoundPoint& point) {
    const double share = b.time > a.time ? static_cast<double>(point.time - a.time) / (b.time - a.time) : 0;
    return std::hypot(point.x - (a.x + share * (b.x - a.x)), point.y - (a.y + share * (b.y - a.y)));
}

/// Douglas and Peucker's way, by the distance at the same moment: marks what stays between two points that do.
void mark_kept(std::span<const FoundPoint> path, double tolerance, std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> parts{{0, path.size() - 1}};
    while (!parts.empty()) {
        const auto [begin, end] = parts.back();
        parts.pop_back();
        double farthest = tolerance;
        std::size_t at = begin;
        for (std::size_t k = begin + 1; k < end; ++k) {
            const double off = off_way(path[begin], path[end], path[k]);
            if (off <= farthest) continue;
            farthest = off;
            at = k;
        }
        if (at == begin) continue;
        kept[at] = true;
        parts.emplace_back(begin, at);
        parts.emplace_back(at, end);
    }
}

FoundEvent event_of(const Json& event, double width, double height) {
    FoundEvent found;
    found.kind = kind_of(event.at("kind").get<std::string>());
    found.number = event.at("number").get<int>();
    double still = 0;
    for (const Json& stay : event.at("stays")) still += stay.at("seconds").get<double>();
    found.still = whole(still * 10);
    std::vector<FoundPoint> path;
    for (const Json& point : event.at("path")) {
        const Json& place = point.at("place");
        path.push_back({whole(point.at("seconds").get<double>() * 10),
                        whole((place.at("x").get<double>() + 0.5) / width * 1000),
                        whole((place.at("y").get<double>() + 0.5) / height * 1000)});
    }
    found.path = simplified(path, path_tolerance);
    return found;
}

int length_of(const FoundEvent& event) {
    return event.path.empty() ? 0 : event.path.back().time - event.path.front().time;
}

}  // namespace

std::vector<FoundPoint> simplified(std::span<const FoundPoint> path, double tolerance) {
    if (path.size() < 3) return {path.begin(), path.end()};
    std::vector<bool> kept(path.size());
    kept.front() = kept.back() = true;
    mark_kept(path, tolerance, kept);
    std::vector<FoundPoint> points;
    for (std::size_t k = 0; k < path.size(); ++k) {
        if (kept[k]) points.push_back(path[k]);
    }
    return points;
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
    Json json{std::string(1, event.kind), event.number, event.still};
    for (const FoundPoint& point : event.path) {
        for (const int value : {point.time, point.x, point.y}) json.push_back(value);
    }
    return json;
}

FoundEvent found_event_of(const Json& json) {
    FoundEvent event;
    event.kind = kind_of(json.at(0).get<std::string>());
    event.number = json.at(1).get<int>();
    event.still = json.at(2).get<int>();
    for (std::size_t k = before_path; k + 2 < json.size(); k += 3) {
        event.path.push_back({json.at(k).get<int>(), json.at(k + 1).get<int>(), json.at(k + 2).get<int>()});
    }
    return event;
}

}  // namespace vvr
