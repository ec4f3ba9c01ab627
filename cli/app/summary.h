#pragma once

#include <string>
#include <vector>

#include "cli/app/observer.h"
#include "cli/app/report.h"

// Texts for people about a run.
namespace vvr::app {

/// The result of a run in one line.
std::string result_text(const RunContext& context);

/// A summary of the events in one line: "3 events; the longest from 14.0 s to 52.5 s". Uses wall-clock times if known.
std::string events_summary(const std::vector<events::Event>& events, const WallClock& clock);

/// Suggestions for this clip, one sentence each.
std::vector<std::string> advice_on(const Plan& plan, const Observation& seen);

/// Logs all possible problems of the input or the picture.
/// \param advice from advice_on
void log_warnings(const RunContext& context, const std::vector<std::string>& advice, Observer& observer);

}  // namespace vvr::app
