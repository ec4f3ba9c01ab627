#pragma once

#include <nlohmann/json_fwd.hpp>

namespace vvr::page {

/// The kinds of events for the page's scripts, most informative first.
nlohmann::ordered_json json_of_kinds();

}  // namespace vvr::page
