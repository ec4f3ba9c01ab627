#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "cli/options/parse_value.h"

namespace vvr {

/// How the volume is cut.
struct BrickOptions {
    std::optional<Time> length;  ///< of a brick; none = `count` bricks
    int count = 8;
};

void add_options(CLI::App& app, BrickOptions& options);

}  // namespace vvr
