#include "core/labels/time_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace vvr {

namespace {

constexpr double minute = 60;
constexpr double hour = 60 * minute;
constexpr double day = 24 * hour;

constexpr std::array<double, 27> steps{0.01, 0.02,     0.05,     0.1,      0.2,        0.5, 1,       2,       5,
                                       10,   15,       30,       minute,   2 * minute, 300, 600,     900,     1800,
                                       hour, 2 * hour, 3 * hour, 6 * hour, 12 * hour,  day, 2 * day, 7 * day, 30 * day};

std::string clip_time(double seconds, double step) {
    const char* const sign = seconds < 0 ? "-" : "";
    const double size = std::abs(seconds);
    if (step < 1) return fmt::format("{}{:.{}f} s", sign, size, step < 0.1 ? 2 : 1);
    const auto whole = static_cast<std::int64_t>(std::llround(size));
    if (whole >= 3600) return fmt::format("{}{}:{:02}:{:02}", sign, whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}{}:{:02}", sign, whole / 60, whole % 60);
}

std::string wall_time(double seconds, std::int64_t clock, double step) {
    const double at = seconds + static_cast<double>(clock);
    const auto whole = static_cast<std::time_t>(std::floor(at + 1e-6));
    const std::tm parts = fmt::gmtime(whole);
    if (step >= day) return fmt::format("{:%m-%d}", parts);
    if (step >= minute) return fmt::format("{:%H:%M}", parts);
    if (step >= 1) return fmt::format("{:%H:%M:%S}", parts);
    // The fraction without its leading zero.
    return fmt::format("{:%H:%M:%S}", parts) +
           fmt::format("{:.2f}", std::max(0.0, at - std::floor(at + 1e-6))).substr(1);
}

}  // namespace

std::vector<TimeTick> time_ticks(double begin, double end, int most, const WallClock& clock) {
    if (!(end > begin) || most < 1) return {};
    const double offset = clock ? static_cast<double>(*clock) : 0;
    const auto first = [&](double step) { return std::ceil((begin + offset) / step - 1e-9); };
    const auto last = [&](double step) { return std::floor((end + offset) / step + 1e-9); };
    double step = steps.back();
    for (const double candidate : steps) {
        if (last(candidate) - first(candidate) + 1 <= most) {
            step = candidate;
            break;
        }
    }
    // Longer than the table reaches: whole multiples of its last step.
    while (last(step) - first(step) + 1 > most) step *= 2;
    std::vector<TimeTick> ticks;
    for (double i = first(step); i <= last(step); ++i) {
        const double seconds = i * step - offset;
        ticks.push_back({seconds, clock ? wall_time(seconds, *clock, step) : clip_time(seconds, step)});
    }
    return ticks;
}

std::string format_clock(std::int64_t seconds) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

std::string format_moment(double seconds, const WallClock& clock) {
    return clock ? wall_time(seconds, *clock, 1) : clip_time(seconds, 1);
}

std::string format_length(double seconds) {
    if (seconds < 100) return fmt::format("{:.0f} s", seconds);
    const auto minutes = std::llround(seconds / minute);
    return minutes < 100 ? fmt::format("{} min", minutes) : fmt::format("{}:{:02} h", minutes / 60, minutes % 60);
}

std::string format_span(double begin, double end, const WallClock& clock) {
    if (!clock) {
        const double step = end - begin < 20 ? 0.1 : 1;
        if (begin == end) return fmt::format("at {}", clip_time(begin, step));
        return fmt::format("{} to {}", clip_time(begin, step), clip_time(end, step));
    }
    const auto at = [&](double seconds) {
        return fmt::gmtime(static_cast<std::time_t>(std::floor(seconds + static_cast<double>(*clock) + 1e-6)));
    };
    const std::tm from = at(begin);
    const std::tm to = at(end);
    const bool same_day = from.tm_yday == to.tm_yday && from.tm_year == to.tm_year;
    return same_day ? fmt::format("{:%Y-%m-%d %H:%M:%S} to {:%H:%M:%S}", from, to)
                    : fmt::format("{:%Y-%m-%d %H:%M:%S} to {:%Y-%m-%d %H:%M:%S}", from, to);
}

}  // namespace vvr
