#pragma once

#include <CLI/CLI.hpp>

#include "core/fields/options.h"

namespace vvr {

/// Filter, flow and seeds.
void add_options(CLI::App& app, FieldOptions& options);

}  // namespace vvr
