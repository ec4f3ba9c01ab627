#pragma once

#include <algorithm>
#include <array>
#include <string_view>

// What tells which time of day a second of a clip was. A time of day is shown only where one of these does, and then
// together with which.
namespace vvr {

enum class ClockSource {
    none,       ///< nothing tells
    file_name,  ///< the name of the file, or of its folders
    user,       ///< --start-time
    live,       ///< this machine's clock, while a stream came
    container,  ///< creation_time: when the file was written, which need not be when it was recorded
    modified,   ///< when the file was last written, less its length
};

struct ClockSourceRow {
    ClockSource source;
    std::string_view name;   ///< in reports and for --start-time
    std::string_view words;  ///< behind a time, for people
};

inline constexpr std::array clock_sources{
    ClockSourceRow{ClockSource::none, "none", "time of day not known"},
    ClockSourceRow{ClockSource::file_name, "file-name", "by file name"},
    ClockSourceRow{ClockSource::user, "user", "as given"},
    ClockSourceRow{ClockSource::live, "live", "live"},
    ClockSourceRow{ClockSource::container, "container", "when the container was written"},
    ClockSourceRow{ClockSource::modified, "modified", "by when the file was last written"},
};

inline const ClockSourceRow& row_of(ClockSource source) {
    return *std::ranges::find(clock_sources, source, &ClockSourceRow::source);
}

/// Whether a picture shows this clock without being asked to: when a file was written is no evidence of when what it
/// shows happened.
inline constexpr bool is_recording_time(ClockSource source) {
    return source == ClockSource::file_name || source == ClockSource::user || source == ClockSource::live;
}

}  // namespace vvr
