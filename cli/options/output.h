#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options/comparison.h"
#include "cli/options/events.h"
#include "core/image/name_pattern.h"

namespace vvr {

/// Where the picture goes, or the pictures, and what is said of it.
struct OutputOptions {
    std::filesystem::path path;
    std::filesystem::path page;       ///< beside the picture; empty = none, unless `path` is one
    std::filesystem::path thumbnail;  ///< empty = none
    bool plain_name = false;          ///< nothing in the path's name is a field
    std::optional<int> animate;       ///< pictures of the moving texture
    std::filesystem::path report;     ///< empty = nowhere
    EventChoice events;               ///< that the report and the page list
    GoldenOptions golden;
};

void add_options(CLI::App& app, OutputOptions& options);

/// \throws Error usage when nothing says where the picture goes, or the name and the number of pictures don't fit
void check(const OutputOptions& options);

/// \throws Error usage when the report would be written over an input
void check_report(const OutputOptions& options, const std::vector<std::string>& inputs);

/// The names of the files that the output goes to.
/// \throws Error usage
NamePattern name_of(const OutputOptions& options);

/// Whether the name is that of a series: a picture for each brick.
bool is_series(const OutputOptions& options);

/// Whether the name is that of a page, which holds the picture and what is to be seen in the clip.
bool is_page(const OutputOptions& options);

/// Where a page goes, be it the output itself or beside it; empty = nowhere.
const std::filesystem::path& page_of(const OutputOptions& options);

/// The number of pictures that the options ask for: none where only a report is wanted. A file that can be animated is.
int pictures_of(const OutputOptions& options);

}  // namespace vvr
