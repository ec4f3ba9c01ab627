#include "cli/app/layers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cli/app/settings.h"
#include "core/base/error.h"

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

}  // namespace vvr::app
