#include "core/tracking/event_line.h"

#include <nlohmann/json.hpp>

#include "core/base/json_text.h"
#include "core/base/text.h"
#include "core/tracking/path.h"

namespace vvr::tracking {

namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(std::string_view text) {
    return text.empty() ? Json() : Json(text);
}

}  // namespace

std::string_view direction_of(const Event& event) {
    // Nobody saw an event with evidence come or go.
    if (event.evidence || event.path.size() < 2 || !(event.path_length > 0)) return {};
    return heading_of(event.path, event.path_length).name;
}

std::string format_event_line(const EventLine& line) {
    constexpr std::string_view here = "./";  // of relative URLs, which programs put behind an address
    const std::string_view page = line.page;
    const Json json{
        {"camera", text_or_null(line.camera)},
        {"clip", line.clip},
        {"number", line.number},
        {"kind", name_of(line.kind)},
        {"class", line.what != nullptr ? Json(line.what->name) : Json()},
        {"begin", line.begin ? Json(*line.begin) : Json()},
        {"end", line.end ? Json(*line.end) : Json()},
        {"first", rounded(line.first)},
        {"last", rounded(line.last)},
        {"seconds", rounded(line.last - line.first)},
        {"open_ended", line.open_ended},
        {"box",
         {{"x", line.box.left}, {"y", line.box.top}, {"width", line.box.width()}, {"height", line.box.height()}}},
        {"direction", text_or_null(line.direction)},
        {"page", text_or_null(page.starts_with(here) ? page.substr(here.size()) : page)}};
    return json_text(json) + "\n";
}

}  // namespace vvr::tracking
