#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "cli/plan/settings.h"
#include "core/base/plane.h"
#include "core/base/setting.h"
#include "core/media/frame_span.h"

/// Parsing of option values. Each function throws Error usage with the given text and what was expected.
namespace vvr::options {

/// The texts between commas.
std::vector<std::string> split_list(const std::string& text);

double parse_number(std::string_view text, Range range);

/// A number, or a fraction whose second part may be a duration: `29.97`, `30000/1001`, `1/24s`.
double parse_rate(std::string_view text, Range range);
std::int64_t parse_integer(std::string_view text, std::int64_t low, std::int64_t high);

/// `1280x800`; each side from 1 to 16384 pixels.
Size parse_size(std::string_view text);

/// Two numbers with `separator` between them: `0.45:1`, `-20,35`.
std::pair<double, double> parse_pair(std::string_view text, char separator, Range first, Range second);

/// A duration in seconds: `90s`, `0.5s`, `10m`, `1h30m`, `1d`, `00:01:30`. The default unit is seconds.
double parse_duration(std::string_view text, Range range = {0, 1e9});

/// A duration rounded up to whole seconds.
std::chrono::seconds parse_whole_seconds(std::string_view text);

/// A number of bytes with decimal prefixes: `500M`, `2G`, `2GB`.
std::int64_t parse_bytes(std::string_view text);

/// `2/8`: the second of eight shares.
std::pair<int, int> parse_share(std::string_view text);

/// A time in a clip, or a length: a duration as above, or frames: `250f`. A number other than 0 needs a unit, as it
/// could be either.
app::Time parse_time(std::string_view text);

/// A time in a clip as above, or a wall-clock time: `2026-11-22 02:00`, or `@02:00` for the next time that the clock
/// shows it. `seconds_of` (core/media/frame_span.h) converts the latter to seconds of the clip. Without the @, 02:00 is
/// two minutes from the beginning.
std::variant<app::Time, media::RequestedTime> parse_place(std::string_view text);

/// `12:00`, `6:30`.
std::chrono::minutes parse_minute_of_day(std::string_view text);

/// `02:00-05:00`: a part of each day.
media::DayPart parse_day_part(std::string_view text);

}  // namespace vvr::options
