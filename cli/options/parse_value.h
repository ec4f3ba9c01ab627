#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "cli/app/job.h"
#include "core/base/plane.h"
#include "core/base/setting.h"
#include "core/video/frame_span.h"

/// Texts of the command line to values. Each function throws Error usage with what it was given and what it takes.
namespace vvr::options {

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
app::Time parse_time(std::string_view text);

/// `2026-11-21 08:00:00` or `2026-11-21T08:00`, in seconds since 1970 on that clock; nothing for any other text.
std::optional<std::int64_t> parse_date_time(std::string_view text);

/// A place in a clip: a time as above, or one by the clock on the wall, which `seconds_of` (core/video/frame_span.h)
/// turns into seconds of the clip: `2026-11-22 02:00`, or `@02:00` for the next time that the clock shows that.
/// Without the @, 02:00 is two minutes from the beginning.
std::variant<app::Time, video::RequestedTime> parse_place(std::string_view text);

/// `02:00-05:00`, a part of each day.
video::DayPart parse_day_part(std::string_view text);

}  // namespace vvr::options
