#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/archive/sidecar.h"
#include "core/footage/recorder_names.h"
#include "core/tracking/event_line.h"

// What is reported to other programs of the events of an archive (`vvr archive --events-to`).
namespace vvr::archive {

/// What an older report has of a clip or of a day. Its events were reported when it was made.
struct OlderReport {
    bool exists = false;
    double end = 0;                 ///< of a clip, seconds from its first frame
    std::set<std::string> files{};  ///< of a day
};

/// Reads an older report; an invalid one counts as none.
OlderReport read_older_report(const std::filesystem::path& report);

/// What a report is about.
enum class Reported { clip, day };

/// The events of a report that an older report can't have: of a clip, those that began after its end; of a day, those
/// that began in a file that it did not have; and the intervals in which the recording was at fault. Their files are
/// those of the report; they have no camera and no page. \throws Error io for an invalid report
std::vector<tracking::EventLine> new_events(const std::filesystem::path& report, const OlderReport& older,
                                            Reported about);

/// The lines of a clip or a day in a table of events: one without events has a line too, one whose events were not
/// looked for has none. \throws Error io if its report can't be read
std::string table_lines_of(const std::filesystem::path& out, const Sidecar& sidecar,
                           const footage::RecorderNames& names);

}  // namespace vvr::archive
