#include "core/page/heading.h"

#include <array>
#include <chrono>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

namespace vvr::page {

namespace {

constexpr std::array<std::string_view, 7> weekdays{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
constexpr std::array<std::string_view, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                  "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};

/// What a clock on a wall shows.
struct Minute {
    std::chrono::sys_days day;
    std::string time;

    explicit Minute(double seconds) {
        const std::chrono::sys_seconds whole{std::chrono::seconds(std::llround(std::floor(seconds + 1e-4)))};
        day = std::chrono::floor<std::chrono::days>(whole);
        const auto minutes = std::chrono::duration_cast<std::chrono::minutes>(whole - day).count();
        time = fmt::format("{:02}:{:02}", minutes / 60, minutes % 60);
    }

    std::string date() const {
        const std::chrono::year_month_day date(day);
        return fmt::format("{} {} {} {}", weekdays.at(std::chrono::weekday(day).c_encoding()),
                           static_cast<unsigned>(date.day()), months.at(static_cast<unsigned>(date.month()) - 1),
                           static_cast<int>(date.year()));
    }
};

}  // namespace

std::string heading_of(const std::string& name, const WallClock& clock, double begin, double end) {
    if (!clock) return name;
    const Minute first(clock->at(begin));
    const Minute last(clock->at(end));
    const std::string heading = fmt::format("{} · {}, {}", name, first.date(), first.time);
    if (last.day != first.day) return fmt::format("{} – {}, {}", heading, last.date(), last.time);
    return last.time == first.time ? heading : fmt::format("{}–{}", heading, last.time);
}

}  // namespace vvr::page
