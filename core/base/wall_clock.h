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

// Where a clip's time of day comes from. Times of day are shown only if a source is known, and together with it.
namespace vvr {

enum class ClockSource {
    none,       ///< unknown
    file_name,  ///< name of the file or its folders
    user,       ///< --start-time
    live,       ///< this machine's clock while the stream was received
    container,  ///< creation_time: when the file was written, perhaps after the recording
    modified,   ///< modification time minus the clip's length
};

struct ClockSourceRow {
    ClockSource source;
    std::string_view name;   ///< in reports and for --start-time
    std::string_view words;  ///< after a time, for users
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

/// Whether pictures show this clock by default. When a file was written is no evidence of when it was recorded.
inline constexpr bool is_recording_time(ClockSource source) {
    return source == ClockSource::file_name || source == ClockSource::user || source == ClockSource::live;
}

}  // namespace vvr

// Dates and times as text. Their seconds count from 1970-01-01 00:00 of whatever zone they are in.
namespace vvr {

/// Whether a text has the form of a date, "2026-11-21".
bool is_date_text(std::string_view text);

/// The midnight at which a date begins; nothing for a date that the calendar lacks.
std::optional<std::int64_t> seconds_of_date(std::int64_t year, std::int64_t month, std::int64_t day);

/// Parses `02:00`, `2:00` or `02:00:30` to seconds since midnight; nothing for any other text.
std::optional<std::int64_t> parse_time_of_day(std::string_view text);

/// Parses `2026-11-21 08:00:00` or `2026-11-21T08:00`; nothing for any other text.
std::optional<std::int64_t> parse_date_time(std::string_view text);

}  // namespace vvr

// Wall clocks of this machine's time zone: that of TZ, or the system's.
namespace vvr {

/// Local time minus UTC at a time, in seconds.
/// \param utc seconds since 1970
std::int64_t local_offset(std::int64_t utc);

/// Checks that TZ names a time zone of this machine. The C library uses UTC for any other name, and says nothing.
///
/// \throws Error usage if it does not
void check_time_zone();

/// The time zone for users: "CET, UTC+1", "UTC".
/// \param utc seconds since 1970
std::string zone_text(std::int64_t utc);

/// Converts local time to UTC, both in seconds since 1970-01-01 00:00. In the hour that occurs twice, chooses the time
/// nearer to `near`, else the first. A skipped time is counted on from before the change.
/// \param near seconds since 1970, UTC
std::int64_t utc_of_local(std::int64_t wall, std::optional<std::int64_t> near = {});

/// The UTC offset from a time on.
struct ZoneChange {
    std::int64_t from = 0;    ///< seconds since 1970, UTC
    std::int64_t offset = 0;  ///< seconds

    friend bool operator==(const ZoneChange&, const ZoneChange&) = default;
};

/// The offset at `begin` and all its changes until `end`, within the years 1970 to 2199.
/// \param begin, end seconds since 1970, UTC
std::vector<ZoneChange> zone_changes(std::int64_t begin, std::int64_t end);

/// The wall clock of a clip: maps seconds of the clip to local time.
struct Clock {
    /// \param begins local time at second 0 of the clip, in seconds since 1970-01-01 00:00 of any zone
    Clock(std::int64_t begins) : begin(begins) {}

    /// A start or end of daylight saving time.
    struct ClockChange {
        double seconds = 0;   ///< of the clip
        std::int64_t by = 0;  ///< seconds by which the clock jumps forward
    };

    std::int64_t begin;
    std::vector<ClockChange> changes{};
    std::optional<std::int64_t> utc_offset{};  ///< seconds, at second 0; none = unknown
    std::string zone{};                        ///< "CET, UTC+1"; empty = unknown
    ClockSource source = ClockSource::user;    ///< of `begin`
    double lasts = 0;                          ///< seconds of the clip that are shown; times of over a day need the day

    /// The local time at a second of the clip, in the units of `begin`.
    double at(double seconds) const;

    /// The second of the clip at which the clock first showed `shown`, negative before the clip; for a skipped time,
    /// the second of the jump.
    double when(double shown) const;

    /// The local time as ISO 8601: "2026-11-21T08:00:07+01:00"; without the offset if it is unknown.
    std::string iso(double seconds) const;
};

/// None if the recording time is unknown.
using WallClock = std::optional<Clock>;

/// A clip's clock in this machine's time zone.
/// \param begin of the clip, seconds since 1970 (UTC)
/// \param length of the clip, seconds
Clock local_clock(std::int64_t begin, double length, ClockSource source);

}  // namespace vvr
