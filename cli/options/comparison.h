#pragma once

#include <filesystem>

#include <CLI/CLI.hpp>

#include "core/image/compare.h"

namespace vvr {

/// What two pictures may differ by, and where a picture of it goes: in `compare` and in `render --golden`.
struct ComparisonOptions {
    Tolerance tolerance;
    std::filesystem::path diff;  ///< empty = nowhere
};

/// What a render is compared with.
struct GoldenOptions {
    std::filesystem::path path;  ///< empty = with nothing
    bool bless = false;
    ComparisonOptions comparison;
};

void add_options(CLI::App& app, ComparisonOptions& options);
void add_options(CLI::App& app, GoldenOptions& options);

/// \throws Error usage for a diff of a format that can't be written, io for a place that can't
void check(const ComparisonOptions& options);

/// The same, for the golden picture too where it is to be written, and that no option stands without one that needs it.
void check(const GoldenOptions& options);

}  // namespace vvr
