#pragma once

#include <string>

#include <nlohmann/json.hpp>
#include <spdlog/logger.h>

#include "core/image/compare.h"

namespace vvr {

/// The numbers, one a line.
std::string numbers_of(const Comparison& comparison);

/// The same for programs; what was not reached is null.
nlohmann::ordered_json json_of(const Comparison& comparison);

/// Tells people where two pictures differ: the worst pixels, and a picture in letters. Nothing where there are no
/// numbers.
void log_difference(const Comparison& comparison, const Tolerance& tolerance, spdlog::logger& log);

}  // namespace vvr
