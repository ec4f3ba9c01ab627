#pragma once

#include <string>
#include <vector>

#include "cli/app/drawn.h"
#include "cli/app/observer.h"

// What people are told of a run.
namespace vvr::app {

/// What came of it, in a line.
std::string outcome_of(const Drawn& drawn);

/// What a person wants to know of the events in a line: "3 events; the longest from 14.0 s to 52.5 s".
/// With times of day where they are known.
std::string summary_of(const std::vector<events::Event>& events, const WallClock& clock);

/// What would serve this clip better, each in a sentence.
std::vector<std::string> advice_on(const Plan& plan, const Observation& seen);

/// All that may be wrong with the input or the picture.
void tell_warnings(const Drawn& drawn, Observer& observer);

}  // namespace vvr::app
