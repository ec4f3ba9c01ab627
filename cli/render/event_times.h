#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace vvr {

/// When an event begins and ends, seconds from the clip's first frame.
struct EventTimes {
    double first = 0;
    double last = 0;
};

/// The events that a report lists, in the order of their numbers.
struct ReportedEvents {
    std::string clip;  ///< as the report names it
    std::vector<EventTimes> times;
};

/// Reads them from a report of `vvr render --report`.
/// \throws Error io where the file can't be read, usage where it is no such report or has no events
ReportedEvents read_events(const std::filesystem::path& report);

}  // namespace vvr
