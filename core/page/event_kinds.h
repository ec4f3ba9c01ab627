#pragma once

#include <nlohmann/json_fwd.hpp>

namespace vvr::page {

/// What scripts know of the kinds of events, those that tell most first.
nlohmann::ordered_json json_of_kinds();

}  // namespace vvr::page
