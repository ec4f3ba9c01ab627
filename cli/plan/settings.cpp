#include "cli/plan/settings.h"

#include <algorithm>

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

namespace {

/// Checks that numbers are within the range of their setting. Values of other types have no range.
struct InRange {
    void operator()(const Setting& setting, const auto& value, const auto&...) const { check(setting, value); }
    void operator()(const Setting& setting, const auto& value, const Word&) const {
        if (value != 0) check(setting, value);
    }
};

}  // namespace

void validate_series(const RenderJob& job) {
    if (job.bricks.time == TimeScale::busy) {
        throw Error(ErrorCode::options_conflict,
                    "time busy needs one picture of the whole clip; the pictures of a series share one scale of time",
                    {setting::time.name});
    }
}

void validate(const RenderJob& job) {
    if (job.input.names.empty())
        throw Error(ErrorCode::input_missing, "no input: name a video, a folder of pictures, or - for stdin");
    fields::validate(job.fields);
    constexpr InRange in_range;
    in_range(setting::rate, job.input.rate, Word{""});
    in_range(setting::track, job.input.track, Word{""});
    in_range(setting::step, job.bricks.step);
    each_brick_setting(job.bricks, in_range);
    each_view_setting(job, in_range);
    each_look_setting(job, in_range);
    in_range(setting::radius, job.shape.r_min);
    in_range(setting::radius, job.shape.r_max);
    if (job.bricks.length && job.bricks.length->value <= 0) {
        throw Error(ErrorCode::option_value_out_of_range, "brick: its length must be greater than 0",
                    {setting::brick.name});
    }
    if (job.bricks.time == TimeScale::busy && job.bricks.step > 0) {
        throw Error(ErrorCode::options_conflict,
                    "step: with time busy, layers have unequal numbers of frames; drop one of the two",
                    {setting::step.name, setting::time.name});
    }
    if (is_series(job.output)) validate_series(job);
}

}  // namespace vvr::app
