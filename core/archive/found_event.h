#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/events/way.h"

namespace vvr::archive {

/// What an archive knows of an event of a clip.
struct FoundEvent {
    char kind = 'm';                     ///< the first letter of its kind: m(oved), s(tood), l(eft), t(aken)
    int number = 0;                      ///< in the picture, the page and the report
    int still = 0;                       ///< tenths of a second for which it kept its place
    std::vector<events::Waypoint> path;  ///< its way, from its first to its last moment

    friend bool operator==(const FoundEvent&, const FoundEvent&) = default;
};

/// The events of a report of `vvr render --report`, with simplified ways; at most `most`, those that last longest.
/// \throws nlohmann::json::exception for what is no report
std::vector<FoundEvent> found_events(const nlohmann::ordered_json& report, std::size_t most = 1000);

/// As a sidecar and the index have it: ["l", 4, 261, 129, 500, 700, 390, 500, 700].
nlohmann::ordered_json json_of(const FoundEvent& event);

/// \throws nlohmann::json::exception for what `json_of` does not make
FoundEvent found_event_of(const nlohmann::ordered_json& json);

}  // namespace vvr::archive
