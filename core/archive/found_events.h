#pragma once

#include <cstddef>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "core/detector/classes.h"
#include "core/tracking/event_kind.h"
#include "core/tracking/path.h"

namespace vvr::archive {

/// What an archive knows of an event.
struct FoundEvent {
    tracking::EventKind kind = tracking::EventKind::moved;
    int number = 0;                        ///< in the picture, the page and the report
    int still = 0;                         ///< the sum of its stays, tenths of a second; of older sidecars, the longest
    std::vector<tracking::Waypoint> path;  ///< its simplified path, from its first to its last moment
    const detector::ObjectClass* what = nullptr;  ///< null = unknown

    friend bool operator==(const FoundEvent&, const FoundEvent&) = default;
};

/// The events of a report (`vvr render --report`) with simplified paths; at most `most`, the longest ones.
/// \throws nlohmann::json::exception for an invalid report, Error io for an unknown kind of event or class of objects
std::vector<FoundEvent> found_events(const nlohmann::ordered_json& report, std::size_t most = 1000);

/// An untrusted number, rounded, and clamped to the range of int.
int whole(double value);

/// The duration, tenths of a second.
int length_of(const FoundEvent& event);

/// The form in sidecars and the index: ["left", 4, 261, 129, 500, 700, 390, 500, 700, "suitcase"]. The class comes
/// last, where it is known.
nlohmann::ordered_json json_of(const FoundEvent& event);

/// Parses that form.
/// \throws nlohmann::json::exception for anything that `json_of` doesn't make, Error io for an unknown kind of event
FoundEvent found_event_of(const nlohmann::ordered_json& json);

}  // namespace vvr::archive
