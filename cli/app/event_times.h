#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/file_digest.h"
#include "core/video/frame_source.h"

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

}  // namespace vvr::app
