#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/parse_value.h"
#include "core/bricks/brick.h"

namespace vvr {

/// How the volume is cut.
struct BrickOptions {
    std::optional<Time> brick;  ///< length of a brick; none = the clip is cut into `window` bricks
    int window = 8;
};

void add_options(CLI::App& app, BrickOptions& options);

/// Layers that the window holds at most; `rate` turns seconds into frames, 0 = unknown.
/// \throws Error usage for a brick in seconds of a clip without a rate, or one that is too long for a texture
std::int64_t window_layers(const BrickOptions& options, double rate);

/// The bricks of a volume of so many layers.
std::vector<Brick> cut(const BrickOptions& options, std::int64_t layers, double rate);

}  // namespace vvr
