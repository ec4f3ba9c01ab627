#pragma once

#include <filesystem>

#include <CLI/CLI.hpp>

namespace vvr {

/// Where the picture goes.
struct OutputOptions {
    std::filesystem::path path;
};

void add_options(CLI::App& app, OutputOptions& options);

/// \throws Error usage when nothing says where the picture goes
void check(const OutputOptions& options);

}  // namespace vvr
