#include "core/tracking/event_line.h"

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

}  // namespace vvr::tracking
