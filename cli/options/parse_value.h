#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "cli/render/time.h"
#include "core/plane.h"
#include "core/setting.h"

/// Texts of the command line to values. Each function throws Error usage with what it was given and what it takes.
namespace vvr {

double parse_number(std::string_view text, Range range);
std::int64_t parse_integer(std::string_view text, std::int64_t low, std::int64_t high);

/// `1280x800`, each side 1..16384.
Size parse_size(std::string_view text);

/// Two numbers with `separator` between them: `0.45:1`, `-20,35`.
std::pair<double, double> parse_pair(std::string_view text, char separator, Range first, Range second);

/// A length of time: `90s`, `10m`, `2h`, `1d`; seconds where no unit is given.
std::chrono::seconds parse_duration(std::string_view text);

/// A number of bytes: `500M`, `2G`, `2GB`, decimal.
std::int64_t parse_bytes(std::string_view text);

/// `2/8`: the second of eight shares.
std::pair<int, int> parse_share(std::string_view text);

/// `250` (frame), `12.5s`, `00:00:12.5` or `00:12.5`.
Time parse_time(std::string_view text);

}  // namespace vvr
