#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/app/job.h"
#include "cli/app/observer.h"
#include "core/base/digest.h"
#include "core/video/frame_source.h"
#include "core/video/frame_span.h"
#include "core/video/recording.h"

namespace vvr::app {

/// When an event begins and ends, seconds from the first frame of the clip or recording.
struct EventTimes {
    double first = 0;
    double last = 0;
};

/// A file that a report is about.
struct ReportedFile {
    video::SegmentPlace place;  ///< in the recording, or from 0 on without an end where it is all of the clip
    FileDigest digest;
};

/// The events that a report lists, in the order of their numbers, and the files in which they lie.
struct ReportedEvents {
    std::vector<ReportedFile> files;
    std::vector<EventTimes> times;
};

/// Reads them from a report of `vvr render --report`.
/// \throws Error io where the file can't be read, usage where it is no such report or has no events
ReportedEvents read_events(const std::filesystem::path& report);

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
