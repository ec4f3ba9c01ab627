#include "cli/app/plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/app/settings.h"
#include "core/base/error.h"
#include "core/base/memory.h"

namespace vvr::app {

namespace {

constexpr double default_seconds = 10;
constexpr double default_frames = 100;  // where the frames per second are unknown

double frames_of_brick(const BrickOptions& bricks, const fields::FieldSource& source) {
    const video::VideoInfo& info = source.info();
    if (bricks.length && bricks.length->unit == Time::Unit::frames) return bricks.length->value;
    if (bricks.length) {
        if (info.rate > 0) return bricks.length->value * info.rate;
        throw Error(ErrorKind::usage,
                    fmt::format("brick of {} s: '{}' does not say how many frames it has per second; give the length "
                                "of a brick in frames, for example {:.0f}f",
                                bricks.length->value, info.name, default_frames),
                    {setting::brick.name});
    }
    const double brick = info.rate > 0 ? default_seconds * info.rate : default_frames;
    const auto expected = static_cast<double>(source.expected_frames());
    return expected > 0 ? std::min(brick, std::ceil(expected / bricks.window)) : brick;
}

}  // namespace

bool is_short_recording(const fields::FieldSource& source) {
    const double rate = source.info().rate;
    const std::int64_t frames = source.expected_frames();
    return rate > 0 && frames > 0 && static_cast<double>(frames) <= short_recording * rate;
}

std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames) {
    if (bricks.step > 0) return bricks.step;
    return std::max<std::int64_t>(1, (frames + bricks.max_layers - 1) / bricks.max_layers);
}

int textures_of(const Products& products, int pieces) {
    const bool drawn_again = products.series || products.pictures > 1 || products.pixel_data;
    return std::max(1, drawn_again ? pieces : std::min(2, pieces));
}

SlidingWindow sliding_window(const BrickOptions& bricks, const fields::FieldSource& source) {
    SlidingWindow window;
    window.bricks = bricks.window;
    const double brick = std::max(1.0, std::round(frames_of_brick(bricks, source)));
    const auto frames = static_cast<std::int64_t>(brick) * bricks.window;
    window.step = planned_step(bricks, frames);
    while (frames > bricks.max_layers * window.step) window.step *= 2;
    const double layers = std::round(brick / static_cast<double>(window.step));
    window.brick_layers = std::max<std::int64_t>(1, static_cast<std::int64_t>(layers));
    return window;
}

namespace {

std::int64_t area(Size size) {
    return std::int64_t{size.width} * size.height;
}

std::int64_t bricks_of(const BrickOptions& bricks, const Plan& plan, double rate) {
    if (!bricks.length) return std::min<std::int64_t>(bricks.window, plan.layers);
    const double length = bricks.length->value * (bricks.length->unit == Time::Unit::seconds ? rate : 1);
    if (length <= 0) return std::min<std::int64_t>(bricks.window, plan.layers);
    return static_cast<std::int64_t>(std::ceil(static_cast<double>(plan.layers * plan.step) / length));
}

std::int64_t bytes_of(const RenderJob& job, const Products& products, const Plan& plan,
                      const fields::FieldSource& source) {
    constexpr std::int64_t program = 230'000'000;  // code, libraries, OpenGL
    constexpr std::int64_t frames_in_flight = 16;
    constexpr std::int64_t field_bytes = 30;  // per pixel of a frame in flight: colour, planes of floats, flow
    constexpr std::int64_t source_bytes = 2;  // per pixel of a decoded picture
    const std::int64_t picture_bytes = products.pixel_data ? 56 : 20;  // per pixel, as floats and as bytes
    // In a layer and in a texture, with something everywhere; a street scene takes a twentieth and a half of that.
    const std::int64_t voxel_bytes =
        job.picture.colour == gl::VolumeColour::own || job.picture.colour == gl::VolumeColour::object ? 4 : 1;
    const auto pieces = static_cast<int>((plan.layers + bricks::sub_brick_layers - 1) / bricks::sub_brick_layers);
    const std::int64_t layers_in_textures = plan.layers * textures_of(products, pieces) / std::max(1, pieces);
    // Unequal layers are half as many again while they are read, and `auto` holds even ones beside them. Where room is
    // given to motion, most of them hold little.
    const bool is_even =
        job.bricks.time == TimeScale::even || (job.bricks.time == TimeScale::automatic && is_short_recording(source));
    const std::int64_t held_layers = products.series || is_even ? 1 : 2;
    // The flow of about a hundred frames, in half floats.
    const std::int64_t flow_bytes = job.look.show.any(&PartRow::needs_flow) ? 100 * 4 : 0;
    // Per pixel of the field: since when it has its value, and whose it is.
    const std::int64_t event_bytes = finds_objects(job, products) ? 40 : 0;
    return program + event_bytes * area(source.field_size()) + flow_bytes * area(source.field_size()) +
           voxel_bytes * (held_layers * plan.layers + layers_in_textures) * area(source.field_size()) +
           frames_in_flight * (field_bytes * area(source.field_size()) + source_bytes * area(source.info().size)) +
           picture_bytes * area(job.picture.size);
}

}  // namespace

void check_memory(const Plan& plan) {
    const std::int64_t there = machine_memory();
    if (there <= 0 || plan.bytes <= there) return;
    throw Error(
        ErrorKind::limit,
        fmt::format("this would take about {:.1f} GB of memory, and the machine has {:.1f} GB; choose a smaller "
                    "picture, smaller fields or fewer layers",
                    static_cast<double>(plan.bytes) / 1e9, static_cast<double>(there) / 1e9),
        {setting::size.name, setting::field_size.name, setting::layers.name});
}

Plan make_plan(const RenderJob& job, const Products& products, const fields::FieldSource& source) {
    const BrickOptions& bricks = job.bricks;
    Plan plan;
    plan.frames = source.expected_frames();
    if (products.series) {
        const SlidingWindow window = sliding_window(bricks, source);
        plan.step = window.step;
        plan.layers = window.layers();
        plan.bricks = window.bricks;
        plan.bytes = bytes_of(job, products, plan, source);
        return plan;
    }
    plan.step = planned_step(bricks, plan.frames);
    while (plan.frames > bricks.max_layers * plan.step) plan.step *= 2;
    plan.layers = plan.frames > 0 ? (plan.frames + plan.step - 1) / plan.step : bricks.max_layers;
    plan.bricks = bricks_of(bricks, plan, source.info().rate);
    plan.bytes = bytes_of(job, products, plan, source);
    return plan;
}

}  // namespace vvr::app
