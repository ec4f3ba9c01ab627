#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/app/observer.h"
#include "core/image/compare.h"

namespace vvr::app {

/// The numbers, one a line.
std::string numbers_of(const image::Comparison& comparison);

/// The same for programs; what was not reached is null.
nlohmann::ordered_json json_of(const image::Comparison& comparison);

/// Shows where two pictures differ: the worst pixels, and a picture made of letters. Nothing where there are no
/// numbers.
/// \param a what the first picture is, in a word; `b` the second
void show_difference(const image::Comparison& comparison, const image::Tolerance& tolerance, std::string_view a,
                     std::string_view b, Observer& observer);

}  // namespace vvr::app
