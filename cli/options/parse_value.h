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

/// A length of time in seconds: `90s`, `0.5s`, `10m`, `1h30m`, `1d`, `00:01:30`; seconds where no unit is given.
double parse_duration(std::string_view text, Range range = {0, 1e9});

/// The same in whole seconds, rounded up.
std::chrono::seconds parse_whole_seconds(std::string_view text);

/// A number of bytes: `500M`, `2G`, `2GB`, decimal.
std::int64_t parse_bytes(std::string_view text);

/// `2/8`: the second of eight shares.
std::pair<int, int> parse_share(std::string_view text);

/// A place in a clip, or a length of it: a length of time as above, or `250f`, frames. A number without a unit, which
/// could be either, is refused, but for 0.
Time parse_time(std::string_view text);

}  // namespace vvr
