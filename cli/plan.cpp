#include "cli/plan.h"

#include <algorithm>
#include <cmath>

namespace vvr {

namespace {

std::int64_t area(Size size) {
    return std::int64_t{size.width} * size.height;
}

std::int64_t bricks_of(const RenderJob& job, const Plan& plan, double rate) {
    const double length = job.brick_seconds > 0 ? job.brick_seconds * rate : static_cast<double>(job.brick_frames);
    if (length <= 0) return std::min<std::int64_t>(job.bricks, plan.layers);
    return static_cast<std::int64_t>(std::ceil(static_cast<double>(plan.layers * plan.step) / length));
}

std::int64_t bytes_of(const RenderJob& job, const Plan& plan, const FrameSource& source) {
    constexpr std::int64_t program = 120'000'000;  // code, libraries, OpenGL
    constexpr std::int64_t frames_in_flight = 16;
    constexpr std::int64_t field_bytes = 30;    // a pixel of a frame in flight: colour, planes of floats, flow
    constexpr std::int64_t source_bytes = 2;    // a pixel of a decoded picture
    constexpr std::int64_t picture_bytes = 64;  // a pixel: four samples of colour and depth, copies as floats
    return program + 2 * plan.layers * area(source.field_size()) +
           frames_in_flight * (field_bytes * area(source.field_size()) + source_bytes * area(source.info().size)) +
           picture_bytes * area(job.picture.size);
}

}  // namespace

Plan make_plan(const RenderJob& job, const FrameSource& source) {
    Plan plan;
    plan.frames = expected_frames(source.info(), job.source);
    plan.step = planned_step(job, plan.frames);
    while (plan.frames > job.max_layers * plan.step) plan.step *= 2;
    plan.layers = plan.frames > 0 ? (plan.frames + plan.step - 1) / plan.step : job.max_layers;
    plan.bricks = bricks_of(job, plan, source.info().rate);
    plan.bytes = bytes_of(job, plan, source);
    return plan;
}

}  // namespace vvr
