#include "cli/app/settings.h"

#include <type_traits>

#include "core/base/error.h"
#include "core/fields/options.h"
#include "core/image/text.h"

namespace vvr::app {

namespace {

/// Checks that numbers are within the range of their setting. Values of other types have no range.
struct CheckRange {
    template <class Value, class... Rest>
    void operator()(const Setting& setting, const Value& value, const Rest&...) const {
        if constexpr (!std::is_same_v<Value, bool>) check(setting, value);
    }
    template <class Number>
    void operator()(const Setting& setting, const NumberOrWord<Number>& number) const {
        if (number.value != 0) check(setting, number.value);
    }
    template <class Shape>
    void operator()(const Setting& setting, const Radii<Shape>& radii) const {
        check(setting, radii.shape.r_min);
        check(setting, radii.shape.r_max);
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
    each_picture_setting(job, CheckRange());
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
