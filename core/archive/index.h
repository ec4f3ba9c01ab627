#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/archive/sidecar.h"
#include "core/footage/recorder_names.h"

namespace vvr::archive {

/// Makes the page that lists an archive's pictures by day and camera, newest first; it belongs in their folder. The
/// text depends on the arguments only.
/// \param names rules by which a clip's name gives camera and time
/// \param gone paths of clips that no longer exist
std::string make_index(const std::vector<Sidecar>& sidecars,
                       const footage::RecorderNames& names = footage::RecorderNames(),
                       const std::set<std::string>& gone = {});

/// Checks that a file in the place of the index is an index.
/// \param out folder of the pictures
/// \throws Error io if it is another file
void check_own_index(const std::filesystem::path& out);

/// The text of each day's file of events, by file name.
using DayFiles = std::map<std::string, std::string>;

/// Makes one file per day with the events of all clips, "index.2026-11-21.js". The index loads those that it needs.
/// They are scripts, because a page opened from a file may load nothing else.
DayFiles make_day_files(const std::vector<Sidecar>& sidecars,
                        const footage::RecorderNames& names = footage::RecorderNames());

/// Whether a file has the name of a day's file of events.
bool is_day_file(std::string_view name);

/// The beginning of a clip, and the source of that time.
struct Begin {
    std::int64_t utc = 0;  ///< seconds since 1970
    ClockSource source = ClockSource::none;
};

/// The date under which the index lists a clip: that of its day or night, or the day of its beginning.
std::string listed_date_of(const Sidecar& sidecar, const footage::RecorderNames& names = footage::RecorderNames());

/// The beginning from the clip's name, else from its container, else from its file's time minus its duration.
Begin begin_of(const Sidecar& sidecar, const footage::RecorderNames& names = footage::RecorderNames());

}  // namespace vvr::archive
