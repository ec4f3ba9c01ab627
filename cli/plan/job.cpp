#include "cli/plan/job.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "core/fields/field_source.h"
#include "core/image/text.h"
#include "core/image/video_encoder.h"

namespace vvr::app {

image::NamePattern name_of(const OutputOptions& options) {
    return options.plain_name ? image::NamePattern::literal(options.path) : image::NamePattern(options.path);
}

bool is_series(const OutputOptions& options) {
    return options.slide || (!options.animate && name_of(options).has_field());
}

bool is_page(const std::filesystem::path& path) {
    const std::string ending = extension_of(path);
    return ending == ".html" || ending == ".htm";
}

const std::filesystem::path& page_of(const OutputOptions& options) {
    return is_page(options.path) ? options.path : options.page;
}

int pictures_of(const OutputOptions& options) {
    if (options.path.empty() && options.golden.path.empty()) return 0;
    if (options.slide) return *options.slide;
    return options.animate.value_or(image::is_animation(options.path) ? default_animation : 1);
}

WallClock clock_of(const StartTime& start, const media::VideoInfo& info) {
    using From = StartTime::From;
    if (start.from == From::given) return start.clock;
    if (start.from == From::none) return std::nullopt;
    const bool known = recording_time_is_known(info);
    struct Row {
        From from;
        std::optional<std::int64_t> begin;
        ClockSource source;
        std::string_view word;
        std::string_view missing;
    };
    const auto begin_by = [&](ClockSource source) {
        return info.began_source == source ? info.began : std::optional<std::int64_t>();
    };
    const auto or_else = [](std::optional<std::int64_t> first, std::optional<std::int64_t> second) {
        return first ? first : second;
    };
    const Row rows[] = {
        {From::automatic, known ? info.began : std::nullopt, info.began_source, "", ""},
        {From::recorded, known ? info.began : std::nullopt, info.began_source, "recorded",
         "the name of '{}' has no date and time; give them, or describe the name with --names"},
        {From::container, or_else(begin_by(ClockSource::container), info.created), ClockSource::container, "container",
         "the container of '{}' has no creation time; give the date and time"},
        {From::modified, or_else(begin_by(ClockSource::modified), info.modified), ClockSource::modified, "modified",
         "'{}' is not a file with a modification time; give the date and time"},
    };
    const Row& row = *std::ranges::find(rows, start.from, &Row::from);
    if (row.begin) return local_clock(*row.begin, info.duration, row.source);
    if (row.missing.empty()) return std::nullopt;
    throw Error(ErrorCode::time_of_day_unknown,
                fmt::format("start-time {}: {}", row.word, fmt::format(fmt::runtime(row.missing), info.name)),
                {"start-time"});
}

}  // namespace vvr::app
