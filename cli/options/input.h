#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options/parse_value.h"
#include "core/video/frame_source.h"
#include "core/video/frame_span.h"

namespace vvr {

/// What is read, and how much of it.
struct InputOptions {
    std::vector<std::string> names;  ///< one, or the directories of an extraction in parts
    std::optional<Time> start;
    std::optional<Time> end;
    int step = 0;  ///< frames a layer of the volume takes; 0 = as many as the window asks for
    Size field_size{0, 0};
    double rate = 25;
};

/// INPUT and how it is read, whatever part of it.
void add_clip_options(CLI::App& app, InputOptions& options);

/// The same and the part that is read.
void add_options(CLI::App& app, InputOptions& options);

/// \throws Error usage unless there is exactly one
const std::string& only_input(const InputOptions& options);

/// Opens the whole of the input.
std::unique_ptr<FrameSource> open_clip(const InputOptions& options, bool colour, int threads);

/// The part of it that is asked for.
/// \throws Error usage for an end before the start
FrameSpan span_of(const InputOptions& options);

}  // namespace vvr
