#include "cli/options_bricks.h"

#include <cmath>

#include <fmt/format.h>

#include "cli/option.h"
#include "core/error.h"

namespace vvr {

namespace {

// One layer for every two or three columns of the default picture along the horseshoe's middle: more would not be seen.
constexpr std::int64_t default_layers = 800;

// 3D textures of OpenGL 3.3 have at most 2048 layers wherever it is; two of them repeat the neighbours'.
constexpr std::int64_t longest_brick = 2046;

std::optional<std::int64_t> brick_layers(const BrickOptions& options, double rate) {
    if (!options.brick) return std::nullopt;
    const bool seconds = options.brick->unit == Time::Unit::seconds;
    if (seconds && rate <= 0) {
        throw Error(ErrorKind::usage, "--brick: this input does not say its frames a second; give the brick in frames");
    }
    const std::int64_t layers = std::llround(seconds ? options.brick->value * rate : options.brick->value);
    if (layers < 1 || layers > longest_brick) {
        throw Error(ErrorKind::usage, fmt::format("--brick: {} frames; allowed are 1 to {}", layers, longest_brick));
    }
    return layers;
}

}  // namespace

void add_options(CLI::App& app, BrickOptions& options) {
    add_option(
        app, group::bricks, options.brick,
        {"--brick", "TIME", "", "length of a brick, 3s or 75; if not given, the clip is cut into --window bricks"},
        parse_time);
    add_integer(app, group::bricks, options.window, 1, 256, {"--window", "COUNT", "", "bricks that are visible"});
}

std::int64_t window_layers(const BrickOptions& options, double rate) {
    const auto layers = brick_layers(options, rate);
    return std::max<std::int64_t>(2, layers ? *layers * options.window : default_layers);
}

std::vector<Brick> cut(const BrickOptions& options, std::int64_t layers, double rate) {
    const auto length = brick_layers(options, rate);
    return length ? cut_by(layers, *length) : cut_into(layers, options.window);
}

}  // namespace vvr
