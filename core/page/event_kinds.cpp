#include "core/page/event_kinds.h"

#include <string_view>

#include <nlohmann/json.hpp>

#include "core/events/event_kind.h"

namespace vvr::page {

namespace {

using Json = nlohmann::ordered_json;

/// The name of an emphasis, which is also a CSS class.
std::string_view name_of(events::Emphasis emphasis) {
    switch (emphasis) {
        case events::Emphasis::none:
            return "none";
        case events::Emphasis::standing:
            return "standing";
        case events::Emphasis::strong:
            return "strong";
    }
    return {};
}

std::string_view name_of(events::Tally tally) {
    switch (tally) {
        case events::Tally::none:
            return "none";
        case events::Tally::lasts:
            return "lasts";
        case events::Tally::still:
            return "still";
        case events::Tally::count:
            return "count";
    }
    return {};
}

}  // namespace

Json json_of_kinds() {
    Json kinds = Json::array();
    for (const events::EventKindRow& row : events::ranked_kinds()) {
        kinds.push_back({{"name", row.name},
                         {"words", row.words},
                         {"by", row.by},
                         {"isThing", row.is_thing},
                         {"emphasis", name_of(row.emphasis)},
                         {"tally", name_of(row.tally)},
                         {"choice", row.choice != nullptr ? Json(row.choice->name) : Json()}});
    }
    return kinds;
}

}  // namespace vvr::page
