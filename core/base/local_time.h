#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace vvr
