#include "core/base/wall_clock.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <limits>
#include <system_error>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/text.h"

namespace vvr {

namespace {

constexpr std::int64_t day = 86'400;
constexpr std::int64_t last = 7'258'118'400;  // 2200-01-01: bounds the search for times of damaged files

std::tm local(std::int64_t utc) {
    const auto time = static_cast<std::time_t>(utc);
    std::tm parts{};
    ::localtime_r(&time, &parts);
    return parts;
}

/// "UTC+1", "UTC-3:30".
std::string offset_text(std::int64_t seconds) {
    if (seconds == 0) return "UTC";
    const std::int64_t minutes = std::abs(seconds) / 60;
    const std::string text = fmt::format("UTC{}{}", seconds < 0 ? '-' : '+', minutes / 60);
    return minutes % 60 == 0 ? text : text + fmt::format(":{:02}", minutes % 60);
}

}  // namespace

namespace {

/// \param form d = a digit; any other character stands for itself
bool has_form(std::string_view text, std::string_view form) {
    return std::ranges::equal(text, form, [](char c, char place) { return place == 'd' ? is_digit(c) : c == place; });
}

int number_in(std::string_view digits) {
    int number = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    return number;
}

constexpr std::size_t date_length = 10;  // of "2026-11-21"

}  // namespace

bool is_date_text(std::string_view text) {
    return has_form(text, "dddd-dd-dd");
}

std::optional<std::int64_t> seconds_of_date(std::int64_t year, std::int64_t month, std::int64_t day) {
    const std::chrono::year_month_day date{std::chrono::year(static_cast<int>(year)),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok()) return std::nullopt;
    return std::chrono::sys_seconds(std::chrono::sys_days(date)).time_since_epoch().count();
}

std::optional<std::int64_t> parse_time_of_day(std::string_view text) {
    const std::string clock = fmt::format("{}{}", text.find(':') == 1 ? "0" : "", text);
    if (!has_form(clock, "dd:dd") && !has_form(clock, "dd:dd:dd")) return std::nullopt;
    const int hour = number_in(clock.substr(0, 2));
    const int minute = number_in(clock.substr(3, 2));
    const int second = clock.size() > 5 ? number_in(clock.substr(6)) : 0;
    if (hour > 23 || minute > 59 || second > 59) return std::nullopt;
    return (hour * 60 + minute) * 60 + second;
}

std::optional<std::int64_t> parse_date_time(std::string_view text) {
    const std::string_view date = text.substr(0, date_length);
    if (!is_date_text(date) || text.size() == date_length) return std::nullopt;
    if (text[date_length] != ' ' && text[date_length] != 'T') return std::nullopt;
    const auto midnight =
        seconds_of_date(number_in(date.substr(0, 4)), number_in(date.substr(5, 2)), number_in(date.substr(8)));
    const auto clock = parse_time_of_day(text.substr(date_length + 1));
    return midnight && clock ? std::optional(*midnight + *clock) : std::nullopt;
}

std::int64_t local_offset(std::int64_t utc) {
    return local(utc).tm_gmtoff;
}

namespace {

/// Whether a zone is given by its rule instead of by name: "CET-1CEST,M3.5.0,M10.5.0/3".
bool is_zone_rule(std::string_view zone) {
    const std::size_t end = zone.starts_with('<') ? zone.find('>') : zone.find_first_of("+-0123456789");
    constexpr std::size_t least = 3;  // letters of a name
    if (end == std::string_view::npos || end < least) return false;
    const std::size_t digit = zone.find_first_not_of("+->", end);
    return digit != std::string_view::npos && is_digit(zone[digit]) && zone.find('/') >= end;
}

}  // namespace

void check_time_zone() {
    namespace fs = std::filesystem;
    const char* const given = std::getenv("TZ");
    std::string_view zone = given == nullptr ? "" : given;
    if (zone.starts_with(':')) zone.remove_prefix(1);
    if (zone.empty() || zone == "UTC" || zone == "GMT" || is_zone_rule(zone)) return;
    const char* const folder = std::getenv("TZDIR");
    const fs::path zones = folder == nullptr ? "/usr/share/zoneinfo" : folder;
    std::error_code none;
    if (fs::is_regular_file(zones / zone, none)) return;  // an absolute path stands for itself
    throw Error(ErrorCode::option_value,
                fmt::format("TZ: '{}' is no time zone of this machine: '{}' has no such file; give one such as "
                            "Europe/Berlin, or install tzdata",
                            shown_text(zone), zones.string()));
}

std::string zone_text(std::int64_t utc) {
    const std::tm parts = local(utc);
    const std::string offset = offset_text(parts.tm_gmtoff);
    const std::string name = parts.tm_zone == nullptr ? "" : parts.tm_zone;
    // Zones without an abbreviation have their offset as name, "+03".
    const bool named = !name.empty() && name.find_first_of("+-0123456789") == std::string::npos && name != offset;
    return named ? fmt::format("{}, {}", name, offset) : offset;
}

std::int64_t utc_of_local(std::int64_t wall, std::optional<std::int64_t> near) {
    const std::array<std::int64_t, 2> offsets{local_offset(wall - day), local_offset(wall + day)};
    std::optional<std::int64_t> best;
    for (const std::int64_t offset : offsets) {
        const std::int64_t utc = wall - offset;
        if (local_offset(utc) != offset) continue;
        const bool nearer = best && near && std::abs(utc - *near) < std::abs(*best - *near);
        const bool first = best && !near && utc < *best;
        if (!best || nearer || first) best = utc;
    }
    return best.value_or(wall - offsets.front());
}

std::vector<ZoneChange> zone_changes(std::int64_t begin, std::int64_t end) {
    std::vector<ZoneChange> changes{{begin, local_offset(begin)}};
    begin = std::max<std::int64_t>(begin, 0);
    end = std::min(end, last);
    while (begin < end) {
        std::int64_t before = begin;
        std::int64_t after = std::min(begin + day, end);
        begin = after;
        if (local_offset(after) == changes.back().offset) continue;
        while (after - before > 1) {
            const std::int64_t middle = before + (after - before) / 2;
            (local_offset(middle) == changes.back().offset ? before : after) = middle;
        }
        changes.push_back({after, local_offset(after)});
        begin = after;
    }
    return changes;
}

double Clock::at(double seconds) const {
    double shown = static_cast<double>(begin) + seconds;
    for (const ClockChange& change : changes) {
        if (seconds >= change.seconds) shown += static_cast<double>(change.by);
    }
    return shown;
}

double Clock::when(double shown) const {
    double seconds = shown - static_cast<double>(begin);
    double since = -std::numeric_limits<double>::infinity();
    for (const ClockChange& change : changes) {
        if (seconds < change.seconds) break;
        seconds -= static_cast<double>(change.by);
        since = change.seconds;
    }
    return std::max(seconds, since);
}

std::string Clock::iso(double seconds) const {
    const double shown = at(seconds);
    std::string text =
        fmt::format("{:%Y-%m-%dT%H:%M:%S}", fmt::gmtime(static_cast<std::time_t>(std::floor(shown + 1e-6))));
    if (!utc_offset) return text;
    const auto offset = *utc_offset + std::llround(shown - static_cast<double>(begin) - seconds);
    const auto minutes = std::abs(offset) / 60;
    return text + fmt::format("{}{:02}:{:02}", offset < 0 ? '-' : '+', minutes / 60, minutes % 60);
}

Clock local_clock(std::int64_t begin, double length, ClockSource source) {
    const std::vector<ZoneChange> changes = zone_changes(begin, begin + std::llround(std::ceil(length)));
    Clock clock(begin + changes.front().offset);
    clock.utc_offset = changes.front().offset;
    clock.source = source;
    clock.zone = zone_text(begin);
    for (std::size_t i = 1; i < changes.size(); ++i) {
        clock.changes.push_back(
            {static_cast<double>(changes[i].from - begin), changes[i].offset - changes[i - 1].offset});
        clock.zone += fmt::format(", then {}", zone_text(changes[i].from));
    }
    return clock;
}

}  // namespace vvr
