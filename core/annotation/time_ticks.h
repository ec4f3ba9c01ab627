#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"

namespace vvr::annotation {

/// A tick of a time ruler.
struct TimeTick {
    double seconds = 0;  ///< of the clip
    std::string text;
};

/// At most `most` round times from `begin` to `end`. The step is 1, 2 or 5 times a power of ten up to 10 s, then a
/// divisor of a minute, an hour or a day, then whole days. With a wall clock, the times are round on that clock.
std::vector<TimeTick> time_ticks(double begin, double end, int most, const WallClock& clock = {});

/// "2026-11-21 08:00:07" for seconds since 1970.
std::string format_clock(std::int64_t seconds);

/// "0:07", "2:01:07"; with a wall clock "08:00:07".
std::string format_moment(double seconds, const WallClock& clock = {});

/// As `format_moment`, but "Tue 18:06" if more than a day is shown, and "11-24 18:06" if more than a week is.
std::string format_moment_and_day(double seconds, const WallClock& clock);

/// "45 s", "7 min", "3:20 h".
std::string format_duration(double seconds);

/// An interval of a clip: "0.0 s to 7.5 s", "0:00 to 1:07", "0:00 to 2:01:07"; with a wall clock "2026-11-21 08:00:00
/// to 08:01:07".
std::string format_interval(double begin, double end, const WallClock& clock = {});

/// As `format_interval`, with the time zone if known and the source of the time: "… (CET, UTC+1; by file name)".
std::string format_interval_and_zone(double begin, double end, const WallClock& clock = {});

}  // namespace vvr::annotation
