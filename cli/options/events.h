#pragma once

#include <CLI/CLI.hpp>

#include "core/events/event_choice.h"

namespace vvr {

/// Which events a report and a page list.
void add_options(CLI::App& app, EventChoice& choice);

}  // namespace vvr
