#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/plane.h"

/// Texts of the command line to values. Each function throws Error usage with what it was given and what it takes.
namespace vvr {

/// What a number may be, both ends included.
struct Range {
    double low;
    double high;
};

double parse_number(std::string_view text, Range range);
std::int64_t parse_integer(std::string_view text, std::int64_t low, std::int64_t high);

/// `1280x800`, each side 1..16384.
Size parse_size(std::string_view text);

/// Two numbers with `separator` between them: `0.45:1`, `-20,35`.
std::pair<double, double> parse_pair(std::string_view text, char separator, Range first, Range second);

/// One of `names`.
std::string parse_name(std::string_view text, std::span<const std::string> names);

/// A length of time: `90s`, `10m`, `2h`, `1d`; seconds where no unit is given.
std::chrono::seconds parse_duration(std::string_view text);

/// A number of bytes: `500M`, `2G`, `2GB`, decimal.
std::int64_t parse_bytes(std::string_view text);

/// `2/8`: one of so many shares, counted from 1.
std::pair<int, int> parse_share(std::string_view text);

/// A place in a clip.
struct Time {
    enum class Unit { frames, seconds };
    double value = 0;
    Unit unit = Unit::frames;

    friend bool operator==(const Time&, const Time&) = default;
};

/// `250` (frame), `12.5s`, `00:00:12.5` or `00:12.5`.
Time parse_time(std::string_view text);

}  // namespace vvr
