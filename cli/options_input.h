#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/parse_value.h"
#include "core/video/frame_source.h"

namespace vvr {

/// What is read, and how much of it.
struct InputOptions {
    std::string name;
    std::optional<Time> start;
    std::optional<Time> end;
    int step = 0;  ///< frames a layer of the volume takes; 0 = as many as the window asks for
    Size field_size{0, 0};
    double rate = 25;
};

void add_options(CLI::App& app, InputOptions& options);

/// Opens the input between the times asked for.
std::unique_ptr<FrameSource> open_clip(const InputOptions& options, bool colour, int threads);

}  // namespace vvr
