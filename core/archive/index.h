#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/sidecar.h"
#include "core/video/recorder_names.h"

namespace vvr::archive {

/// A page that lists an archive's pictures by day and camera, newest first. It belongs into their folder. Same
/// sidecars, same text.
/// \param names that tell the camera and the time of a clip
/// \param gone paths of the clips that are no longer there
std::string make_index(const std::vector<Sidecar>& sidecars, const video::RecorderNames& names = video::RecorderNames(),
                       const std::set<std::string>& gone = {});

/// Name and text of each file of events.
using DayFiles = std::map<std::string, std::string>;

/// The events of all clips in a file for each day: "index.2026-11-21.js" beside the index, which loads those that it
/// needs. They are scripts, as a page that was opened as a file may load nothing else.
DayFiles make_day_files(const std::vector<Sidecar>& sidecars,
                        const video::RecorderNames& names = video::RecorderNames());

/// Whether a file has the name of a day's.
bool is_day_file(std::string_view name);

/// When a clip begins, and what tells that.
struct Begin {
    std::int64_t utc = 0;  ///< seconds since 1970
    ClockSource source = ClockSource::none;
};

/// As a clip's name says, else its container, else its length before its file was last written.
Begin begin_of(const Sidecar& sidecar, const video::RecorderNames& names = video::RecorderNames());

}  // namespace vvr::archive
