#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/app/event_times.h"
#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/video/frame_span.h"
#include "core/video/recording.h"

namespace vvr::app {

/// A file, or the files of a recording, that a piece can be cut out of.
struct Footage {
    video::Recording recording;  ///< of one file too
    bool is_single = true;       ///< one file was named, and nothing else
};

/// \throws Error usage for what is neither a file with times nor a recording of such
Footage find_footage(const InputOptions& options);

/// A file that a piece reaches into, and what of it is in the piece.
struct FootagePart {
    video::SegmentPlace file;  ///< when it is shown, in seconds of the recording
    video::FrameSpan span;     ///< in seconds or frames of the file
    bool overlaps;             ///< with the file before
};

/// When each file is shown, by its packets: as one that renders the recording finds it. Files that begin after `until`
/// are left out.
std::vector<video::SegmentPlace> place_by_packets(const Footage& footage, double rate, std::optional<double> until,
                                                  Observer& observer);

/// The same as a report has it, for the files in which one of its events lies, and as many of those beside it as the
/// margin reaches into and are there.
/// \param margin seconds before and after the event
/// \throws Error usage where one of the event's files is not among the footage, by size and digest
std::vector<video::SegmentPlace> place_by_report(const Footage& footage, const ReportedEvents& report,
                                                 std::size_t event, double margin, const std::string& report_name);

/// The files that a span reaches into, in order. What a file shows at a time that the one before has shown is left out.
std::vector<FootagePart> parts_in(const std::vector<video::SegmentPlace>& places, const video::FrameSpan& span);

}  // namespace vvr::app
