#pragma once

#include <nlohmann/json.hpp>

#include "cli/options/help.h"

namespace vvr::options {

/// The help of a command for programs. docs/help.schema.json is its schema.
nlohmann::ordered_json help_json(const CommandHelp& help);

/// The titles of the groups, in the order of the help.
nlohmann::ordered_json groups_json();

/// The placeholders that are not self-explanatory.
nlohmann::ordered_json value_kinds_json();

/// The presets, with the options that each sets.
nlohmann::ordered_json presets_json();

}  // namespace vvr::options
