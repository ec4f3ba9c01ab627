#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/clock_source.h"

namespace vvr {

/// The clock on a wall while a clip was recorded.
struct Clock {
    /// \param begins what it showed at second 0 of the clip, in seconds since 1970-01-01 00:00 on that clock, of
    /// whatever
    ///        zone
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
