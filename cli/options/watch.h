#pragma once

#include <optional>

#include <CLI/CLI.hpp>

#include "cli/options/output.h"
#include "cli/options/render_settings.h"

namespace vvr {

/// How long a stream is watched, and how patiently.
struct WatchOptions {
    std::optional<double> duration;  ///< seconds; none = for ever
    double lag = 1;                  ///< seconds that a frame may wait
    double patience = 5;             ///< seconds without a frame
};

void add_options(CLI::App& app, WatchOptions& options);

/// The one option of an output that a stream has.
void add_stream_output(CLI::App& app, OutputOptions& output);

/// \throws Error usage for what only a clip with an end can have
void check_stream(const RenderSettings& settings, const OutputOptions& output);

}  // namespace vvr
