#pragma once

#include <array>
#include <string_view>

namespace vvr::app {

/// How the room along the arc is given to the time of a clip.
enum class TimeScale { automatic, even, busy };

struct TimeScaleRow {
    TimeScale scale;
    std::string_view name;
    std::string_view help;
};

inline constexpr std::array time_scales{
    TimeScaleRow{TimeScale::automatic, "auto",
                 "busy for more than two minutes of which nothing moves for most, else even"},
    TimeScaleRow{TimeScale::even, "even", "all time has the same room"},
    TimeScaleRow{TimeScale::busy, "busy", "room goes where something moves; the ruler marks where time is squeezed"},
};

}  // namespace vvr::app
