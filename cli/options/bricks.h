#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "cli/options/parse_value.h"

namespace vvr {

/// How the volume is cut.
struct BrickOptions {
    std::optional<Time> length;  ///< of a brick; none = what the window asks for
    std::optional<int> count;    ///< of bricks in the window; none = `standard_window`
    double skip_idle = 0;        ///< seconds without motion of which the rest is left out; 0 = nothing is
};

inline constexpr int standard_window = 8;

void add_options(CLI::App& app, BrickOptions& options);

/// \throws Error usage when they contradict each other
void check(const BrickOptions& options, bool series);

}  // namespace vvr
