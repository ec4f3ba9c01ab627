#include "cli/plan/settings.h"

#include "core/base/error.h"
#include "core/fields/options.h"
#include "core/image/text.h"

namespace vvr::app {

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
