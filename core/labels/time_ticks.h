#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/wall_clock.h"

namespace vvr::labels {

/// A moment on a time ruler.
struct TimeTick {
    double seconds = 0;  ///< of the clip
    std::string text;
};

/// The round moments from `begin` to `end`, at most `most` of them: multiples of 1, 2 or 5 of a power of ten below a
/// minute, of what divides a minute, an hour, a day above. With a wall clock they are round on that clock.
std::vector<TimeTick> time_ticks(double begin, double end, int most, const WallClock& clock = {});

/// "2026-11-21 08:00:07" for seconds since 1970.
std::string format_clock(std::int64_t seconds);

/// "0:07", "2:01:07"; with a wall clock "08:00:07".
std::string format_moment(double seconds, const WallClock& clock = {});

/// "45 s", "7 min", "3:20 h".
std::string format_length(double seconds);

/// A part of a clip as people write it: "0.0 s to 7.5 s", "0:00 to 1:07", "0:00 to 2:01:07"; with a wall clock
/// "2026-11-21 08:00:00 to 08:01:07".
std::string format_stretch(double begin, double end, const WallClock& clock = {});

/// The same with the zone where it is known, and what tells the time: "… (CET, UTC+1; by file name)".
std::string format_span(double begin, double end, const WallClock& clock = {});

}  // namespace vvr::labels
