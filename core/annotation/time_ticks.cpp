#include "core/annotation/time_ticks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace vvr::annotation {

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

std::string wall_time(double seconds, const Clock& clock, double step, bool with_day) {
    const double at = clock.at(seconds);
    const auto whole = static_cast<std::time_t>(std::floor(at + 1e-6));
    const std::tm parts = fmt::gmtime(whole);
    if (step > 7 * day) return fmt::format("{:%Y-%m-%d}", parts);
    if (step >= day) return fmt::format("{:%m-%d}", parts);
    if (with_day && clock.lasts > 7 * day) return fmt::format("{:%m-%d %H:%M}", parts);
    if (with_day && clock.lasts > day) return fmt::format("{:%a %H:%M}", parts);
    if (step >= minute) return fmt::format("{:%H:%M}", parts);
    if (step >= 1) return fmt::format("{:%H:%M:%S}", parts);
    // The fraction without its leading zero.
    return fmt::format("{:%H:%M:%S}", parts) +
           fmt::format("{:.2f}", std::max(0.0, at - std::floor(at + 1e-6))).substr(1);
}

/// An interval of a clip without a jump of its clock.
struct Interval {
    double begin = 0;
    double end = 0;
    double offset = 0;       ///< clock minus the clip's seconds
    bool half_open = false;  ///< the end belongs to the next interval

    double first(double step) const { return std::ceil((begin + offset) / step - 1e-9); }
    double last(double step) const {
        return half_open ? std::ceil((end + offset) / step - 1e-9) - 1 : std::floor((end + offset) / step + 1e-9);
    }
};

std::vector<Interval> intervals_of(double begin, double end, const WallClock& clock) {
    std::vector<Interval> intervals{{begin, end, clock ? static_cast<double>(clock->begin) : 0}};
    if (!clock) return intervals;
    for (const Clock::ClockChange& change : clock->changes) {
        if (change.seconds <= begin) {
            intervals.back().offset += static_cast<double>(change.by);
        } else if (change.seconds < end) {
            intervals.back().end = change.seconds;
            intervals.back().half_open = true;
            intervals.push_back({change.seconds, end, intervals.back().offset + static_cast<double>(change.by)});
        }
    }
    return intervals;
}

}  // namespace

std::vector<TimeTick> time_ticks(double begin, double end, int most, const WallClock& clock) {
    if (!(end > begin) || most < 1) return {};
    const std::vector<Interval> intervals = intervals_of(begin, end, clock);
    const auto count = [&](double step) {
        double ticks = 0;
        for (const Interval& interval : intervals) ticks += interval.last(step) - interval.first(step) + 1;
        return ticks;
    };
    double step = steps.back();
    for (const double candidate : steps) {
        if (count(candidate) <= most) {
            step = candidate;
            break;
        }
    }
    // Beyond the table: multiples of its last step.
    while (count(step) > most) step *= 2;
    std::vector<TimeTick> ticks;
    for (const Interval& interval : intervals) {
        for (double i = interval.first(step); i <= interval.last(step); ++i) {
            const double seconds = i * step - interval.offset;
            ticks.push_back({seconds, clock ? wall_time(seconds, *clock, step, true) : clip_time(seconds, step)});
        }
    }
    return ticks;
}

std::string format_clock(std::int64_t seconds) {
    return fmt::format("{:%Y-%m-%d %H:%M:%S}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

std::string format_moment(double seconds, const WallClock& clock) {
    return clock ? wall_time(seconds, *clock, 1, false) : clip_time(seconds, 1);
}

std::string format_moment_and_day(double seconds, const WallClock& clock) {
    return clock ? wall_time(seconds, *clock, 1, true) : clip_time(seconds, 1);
}

std::string format_duration(double seconds) {
    // Rounded to tenths first, as archives store durations, so that all places show the same number.
    const auto whole = std::llround(std::round(seconds * 10) / 10);
    if (whole < 100) return fmt::format("{} s", whole);
    const auto minutes = std::llround(static_cast<double>(whole) / minute);
    return minutes < 100 ? fmt::format("{} min", minutes) : fmt::format("{}:{:02} h", minutes / 60, minutes % 60);
}

std::string format_interval(double begin, double end, const WallClock& clock) {
    if (!clock) {
        const double step = end - begin < 20 ? 0.1 : 1;
        if (begin == end) return fmt::format("at {}", clip_time(begin, step));
        return fmt::format("{} to {}", clip_time(begin, step), clip_time(end, step));
    }
    const auto at = [&](double seconds) {
        return fmt::gmtime(static_cast<std::time_t>(std::floor(clock->at(seconds) + 1e-6)));
    };
    const std::tm from = at(begin);
    const std::tm to = at(end);
    const bool same_day = from.tm_yday == to.tm_yday && from.tm_year == to.tm_year;
    return same_day ? fmt::format("{:%Y-%m-%d %H:%M:%S} to {:%H:%M:%S}", from, to)
                    : fmt::format("{:%Y-%m-%d %H:%M:%S} to {:%Y-%m-%d %H:%M:%S}", from, to);
}

std::string format_interval_and_zone(double begin, double end, const WallClock& clock) {
    std::string span = format_interval(begin, end, clock);
    if (!clock) return span;
    const std::string_view by = row_of(clock->source).words;
    return clock->zone.empty() ? fmt::format("{} ({})", span, by) : fmt::format("{} ({}; {})", span, clock->zone, by);
}

}  // namespace vvr::annotation
