#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vvr {

/// A frame of the clip and its time.
struct Moment {
    std::int64_t frame = 0;  ///< index in the clip
    double seconds = 0;
};

}  // namespace vvr

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

// The clocks on the walls of this machine's time zone: that of TZ, or the system's.
namespace vvr {

/// How far the clock on the wall is ahead of UTC at a moment, in seconds.
/// \param utc seconds since 1970
std::int64_t local_offset(std::int64_t utc);

/// The zone at a moment as people write it: "CET, UTC+1", "UTC".
std::string zone_text(std::int64_t utc);

/// The moment at which a clock on the wall shows a time. In the hour that comes twice it is the one nearer to `near`,
/// else the first; a time that the clock leaps over is counted on from before the leap.
/// \param wall seconds since 1970-01-01 00:00 of the clock on the wall
/// \param near seconds since 1970, UTC
std::int64_t utc_of_local(std::int64_t wall, std::optional<std::int64_t> near = {});

/// From a moment on the clock on the wall is so far ahead of UTC.
struct ZoneChange {
    std::int64_t from = 0;    ///< seconds since 1970, UTC
    std::int64_t offset = 0;  ///< seconds

    friend bool operator==(const ZoneChange&, const ZoneChange&) = default;
};

/// The offset at `begin`, and every change of it until `end`. Of times beyond the years 1970 to 2199, which no clock on
/// a wall shows, no change is known.
std::vector<ZoneChange> zone_changes(std::int64_t begin, std::int64_t end);

/// The clock on a wall while a clip was recorded.
struct Clock {
    /// A clock of whatever zone.
    /// \param begins what it showed at second 0 of the clip, in seconds since 1970-01-01 00:00
    ///        on that clock
    Clock(std::int64_t begins) : begin(begins) {}

    /// When summer time began or ended.
    struct ClockChange {
        double seconds = 0;   ///< of the clip
        std::int64_t by = 0;  ///< seconds by which the clock was put forward
    };

    std::int64_t begin;
    std::vector<ClockChange> leaps{};
    std::optional<std::int64_t> ahead{};     ///< seconds ahead of UTC at second 0; none = nobody knows
    std::string zone{};                      ///< "CET, UTC+1"; empty = nobody knows
    ClockSource source = ClockSource::user;  ///< who says so

    /// What it showed at a second of the clip.
    double at(double seconds) const;

    /// The second of the clip, negative before it began, at which it first showed a time; where it leapt over that, the
    /// second of the leap.
    double when(double shown) const;

    /// The same as ISO 8601: "2026-11-21T08:00:07+01:00"; without the zone where that is not known.
    std::string iso(double seconds) const;
};

/// None where nobody knows when a clip was recorded.
using WallClock = std::optional<Clock>;

/// The clock of this machine's time zone.
/// \param begin of the clip, seconds since 1970 (UTC)
/// \param length of the clip, seconds
Clock local_clock(std::int64_t begin, double length, ClockSource source);

}  // namespace vvr
