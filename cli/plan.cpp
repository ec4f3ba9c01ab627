#include "cli/plan.h"

#include <algorithm>
#include <cmath>

#include "core/plane.h"

namespace vvr {

namespace {

/// Number of the frame at a time, as the container's rate has it.
std::int64_t frame_at(const Time& time, double rate) {
    return std::llround(time.unit == Time::Unit::seconds ? time.value * rate : time.value);
}

std::int64_t frames_asked_for(const InputOptions& input, const VideoInfo& info) {
    std::int64_t frames = info.frames;
    if (input.end) {
        const std::int64_t end = frame_at(*input.end, info.rate);
        frames = frames > 0 ? std::min(frames, end) : end;
    }
    if (input.start) frames = std::max<std::int64_t>(0, frames - frame_at(*input.start, info.rate));
    return frames;
}

std::int64_t area(Size size) {
    return std::int64_t{size.width} * size.height;
}

}  // namespace

Plan make_plan(const RenderJob& job, const FrameSource& source) {
    const VideoInfo& info = source.info();
    const std::int64_t capacity = window_layers(job.bricks, info.rate);
    Plan plan;
    plan.frames = frames_asked_for(job.input, info);
    plan.step = job.input.step;
    while (plan.frames > capacity * plan.step) plan.step *= 2;
    plan.layers = plan.frames > 0 ? (plan.frames + plan.step - 1) / plan.step : capacity;
    plan.bricks = static_cast<std::int64_t>(cut(job.bricks, plan.layers, info.rate).size());

    constexpr std::int64_t program = 120'000'000;            // code and libraries
    constexpr std::int64_t frames_in_flight = 16;            // decoder and pipeline, with their planes of floats
    constexpr std::int64_t bytes_a_pixel = 4 * 8 + 16 + 16;  // four samples of colour and depth, then two float copies
    plan.bytes = program + 2 * plan.layers * area(source.field_size()) +
                 frames_in_flight * 30 * area(source.field_size()) + frames_in_flight * 2 * area(info.size) +
                 bytes_a_pixel * area(job.view.size);
    return plan;
}

}  // namespace vvr
