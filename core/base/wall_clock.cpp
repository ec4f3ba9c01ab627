#include "core/base/wall_clock.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <limits>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "core/base/local_time.h"

namespace vvr {

double Clock::at(double seconds) const {
    double shown = static_cast<double>(begin) + seconds;
    for (const ClockChange& leap : leaps) {
        if (seconds >= leap.seconds) shown += static_cast<double>(leap.by);
    }
    return shown;
}

double Clock::when(double shown) const {
    double seconds = shown - static_cast<double>(begin);
    double since = -std::numeric_limits<double>::infinity();
    for (const ClockChange& leap : leaps) {
        if (seconds < leap.seconds) break;
        seconds -= static_cast<double>(leap.by);
        since = leap.seconds;
    }
    return std::max(seconds, since);
}

std::string Clock::iso(double seconds) const {
    const double shown = at(seconds);
    std::string text =
        fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(static_cast<std::time_t>(std::floor(shown + 1e-6))));
    if (!ahead) return text;
    const auto offset = *ahead + std::llround(shown - static_cast<double>(begin) - seconds);
    const auto minutes = std::abs(offset) / 60;
    return text + fmt::format("{}{:02}:{:02}", offset < 0 ? '-' : '+', minutes / 60, minutes % 60);
}

Clock local_clock(std::int64_t begin, double length, ClockSource source) {
    const std::vector<ZoneChange> changes = zone_changes(begin, begin + std::llround(std::ceil(length)));
    Clock clock(begin + changes.front().offset);
    clock.ahead = changes.front().offset;
    clock.source = source;
    clock.zone = zone_text(begin);
    for (std::size_t i = 1; i < changes.size(); ++i) {
        clock.leaps.push_back(
            {static_cast<double>(changes[i].from - begin), changes[i].offset - changes[i - 1].offset});
        clock.zone += fmt::format(", then {}", zone_text(changes[i].from));
    }
    return clock;
}

}  // namespace vvr
