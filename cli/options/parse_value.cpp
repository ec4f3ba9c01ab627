#include "cli/options/parse_value.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/wall_clock.h"

namespace vvr::options {

namespace {

constexpr double longest_clip = 1e9;

[[noreturn]] void refuse(std::string_view text, std::string_view wanted, ErrorCode code = ErrorCode::option_value) {
    throw Error(code, fmt::format("'{}' is not {}", text, wanted));
}

/// Parses the whole text as a number, independent of the locale.
template <class Number>
std::optional<Number> number(std::string_view text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stopped, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stopped != end) return std::nullopt;
    return value;
}

std::optional<double> number_within(std::string_view text, Range range) {
    const auto value = number<double>(text);
    return value && std::isfinite(*value) && *value >= range.low && *value <= range.high ? value : std::nullopt;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (auto at = text.find(separator); at != std::string_view::npos; at = text.find(separator)) {
        parts.push_back(text.substr(0, at));
        text.remove_prefix(at + 1);
    }
    parts.push_back(text);
    return parts;
}

/// `00:01:30`. Only the last part may have a fraction, and only the first may be 60 or more.
std::optional<double> clock_seconds(std::string_view text) {
    const auto parts = split(text, ':');
    if (parts.size() < 2 || parts.size() > 3) return std::nullopt;
    double seconds = 0;
    for (const std::string_view part : parts) {
        const bool last = part.data() == parts.back().data();
        const bool first = part.data() == parts.front().data();
        const auto value = number_within(part, {0, first ? longest_clip : 59.9999999});
        if (!value || (!last && *value != std::floor(*value))) return std::nullopt;
        seconds = seconds * 60 + *value;
    }
    return seconds <= longest_clip ? std::optional(seconds) : std::nullopt;
}

/// `1h30m`. Units from largest to smallest, each at most once; only the last number may have a fraction.
std::optional<double> unit_seconds(std::string_view text) {
    constexpr std::pair<char, double> units[] = {{'d', 86400}, {'h', 3600}, {'m', 60}, {'s', 1}};
    double seconds = 0;
    bool whole = true;
    for (const auto& [letter, length] : units) {
        const auto end = text.find(letter);
        if (end == std::string_view::npos) continue;
        const auto value = number_within(text.substr(0, end), {0, longest_clip});
        if (!value || !whole) return std::nullopt;
        whole = *value == std::floor(*value);
        seconds += *value * length;
        text.remove_prefix(end + 1);
        if (text.empty()) return seconds <= longest_clip ? std::optional(seconds) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<double> seconds_of(std::string_view text) {
    return text.find(':') == std::string_view::npos ? unit_seconds(text) : clock_seconds(text);
}

}  // namespace

std::vector<std::string> split_list(const std::string& text) {
    if (text.empty()) return {};
    const std::vector<std::string_view> words = split(text, ',');
    return {words.begin(), words.end()};
}

double parse_number(std::string_view text, Range range) {
    const auto value = number_within(text, range);
    if (!value) {
        refuse(text, fmt::format("a number from {} to {}", range.low, range.high),
               number<double>(text) ? ErrorCode::option_value_out_of_range : ErrorCode::option_value);
    }
    return *value;
}

double parse_rate(std::string_view text, Range range) {
    const auto slash = text.find('/');
    if (slash == std::string_view::npos) return parse_number(text, range);
    const auto frames = number_within(text.substr(0, slash), {0, longest_clip});
    const std::string_view rest = text.substr(slash + 1);
    const auto alone = number_within(rest, {0, longest_clip});
    const auto seconds = alone ? alone : seconds_of(rest);
    if (!frames || !seconds || *seconds <= 0) refuse(text, "a rate like 10, 30000/1001 or 1/24s, a frame every 24 s");
    const double rate = *frames / *seconds;
    if (rate < range.low || rate > range.high) {
        refuse(text, fmt::format("a rate from {} to {} frames per second", range.low, range.high),
               ErrorCode::option_value_out_of_range);
    }
    return rate;
}

std::int64_t parse_integer(std::string_view text, std::int64_t low, std::int64_t high) {
    const auto value = number<std::int64_t>(text);
    if (!value || *value < low || *value > high) {
        refuse(text, fmt::format("a whole number from {} to {}", low, high),
               value ? ErrorCode::option_value_out_of_range : ErrorCode::option_value);
    }
    return *value;
}

Size parse_size(std::string_view text) {
    const auto sides = split(text, 'x');
    const auto width = number<std::int64_t>(sides[0]);
    const auto height = sides.size() == 2 ? number<std::int64_t>(sides[1]) : std::nullopt;
    if (!width || !height) refuse(text, "a size like 1280x800");
    for (const std::int64_t side : {*width, *height}) {
        const auto [least, most] = setting::size.range;
        if (static_cast<double>(side) < least || static_cast<double>(side) > most) {
            refuse(text, fmt::format("a size from {0}x{0} to {1}x{1}", least, most),
                   ErrorCode::option_value_out_of_range);
        }
    }
    return {static_cast<int>(*width), static_cast<int>(*height)};
}

std::pair<double, double> parse_pair(std::string_view text, char separator, Range first, Range second) {
    const auto parts = split(text, separator);
    const auto a = number_within(parts[0], first);
    const auto b = parts.size() == 2 ? number_within(parts[1], second) : std::nullopt;
    if (!a || !b) {
        refuse(text,
               fmt::format("two numbers with '{}' between them, the first from {} to {}, the second from {} to {}",
                           separator, first.low, first.high, second.low, second.high));
    }
    return {*a, *b};
}

std::pair<int, int> parse_share(std::string_view text) {
    constexpr int most = 100'000;
    const auto slash = text.find('/');
    const auto share = slash == std::string_view::npos ? std::nullopt : number<int>(text.substr(0, slash));
    const auto count = slash == std::string_view::npos ? std::nullopt : number<int>(text.substr(slash + 1));
    if (!share || !count || *share < 1 || *share > *count || *count > most)
        refuse(text, "a part such as 2/8, the second of eight");
    return {*share, *count};
}

double parse_duration(std::string_view text, Range range) {
    const auto alone = number_within(text, {0, longest_clip});
    const auto seconds = alone ? alone : seconds_of(text);
    if (!seconds) refuse(text, "a length of time like 90s, 1h30m, 00:01:30 or 2d");
    if (*seconds < range.low || *seconds > range.high)
        refuse(text, fmt::format("a length of time from {}s to {}s", range.low, range.high),
               ErrorCode::option_value_out_of_range);
    return *seconds;
}

std::chrono::seconds parse_whole_seconds(std::string_view text) {
    return std::chrono::ceil<std::chrono::seconds>(std::chrono::duration<double>(parse_duration(text)));
}

std::int64_t parse_bytes(std::string_view text) {
    constexpr std::string_view wanted = "a number of bytes like 500M or 2G";
    constexpr std::pair<char, std::int64_t> units[] = {{'K', 1'000}, {'M', 1'000'000}, {'G', 1'000'000'000}};
    std::string_view digits = text;
    if (digits.ends_with('B')) digits.remove_suffix(1);
    std::int64_t bytes = 1;
    for (const auto& [letter, size] : units) {
        if (!digits.ends_with(letter)) continue;
        digits.remove_suffix(1);
        bytes = size;
        break;
    }
    const auto value = number<std::int64_t>(digits);
    if (!value || *value < 1 || *value > 1'000'000'000) refuse(text, wanted);
    return *value * bytes;
}

app::Time parse_time(std::string_view text) {
    if (text.ends_with('f')) {
        const auto frame = number<std::int64_t>(text.substr(0, text.size() - 1));
        if (!frame || *frame < 0 || static_cast<double>(*frame) > longest_clip)
            refuse(text, "a number of frames like 250f");
        return {static_cast<double>(*frame), app::Time::Unit::frames};
    }
    const auto alone = number_within(text, {0, longest_clip});
    if (alone && *alone == 0) return {0, app::Time::Unit::seconds};
    if (alone) {
        const bool whole = *alone == std::floor(*alone);
        throw Error(ErrorCode::option_value, fmt::format("'{0}' has no unit: write {1}{0}s for seconds", text,
                                                         whole ? fmt::format("{}f for frames or ", text) : ""));
    }
    const auto seconds = seconds_of(text);
    if (!seconds) refuse(text, "a time like 12.5s, 1h30m, 00:00:12.5 or 250f, a frame");
    return {*seconds, app::Time::Unit::seconds};
}

std::variant<app::Time, media::RequestedTime> parse_place(std::string_view text) {
    constexpr std::string_view forms = "a date and time like 2026-11-22 02:00, or a time of day like @02:00";
    if (text.starts_with('@')) {
        const auto clock = parse_time_of_day(text.substr(1));
        if (!clock) refuse(text, forms);
        return media::RequestedTime{*clock, false, std::string(text)};
    }
    if (const auto seconds = parse_date_time(text)) return media::RequestedTime{*seconds, true, std::string(text)};
    // An invalid date, or a date without a time.
    if (text.size() > 4 && text[4] == '-') refuse(text, forms);
    return parse_time(text);
}

std::chrono::minutes parse_minute_of_day(std::string_view text) {
    const auto seconds = parse_time_of_day(text);
    if (!seconds || *seconds % 60 != 0) refuse(text, "a time of day like 12:00");
    return std::chrono::minutes(*seconds / 60);
}

media::DayPart parse_day_part(std::string_view text) {
    const auto ends = split(text, '-');
    const auto begin = parse_time_of_day(ends.front());
    const auto end = ends.size() == 2 ? parse_time_of_day(ends.back()) : std::nullopt;
    if (!begin || !end || *begin == *end) refuse(text, "a part of the day like 02:00-05:00");
    return {*begin, *end, std::string(text)};
}

}  // namespace vvr::options
