#pragma once

#include <span>
#include <string>
#include <string_view>

namespace vvr {

/// Number of letters to insert, delete, replace or swap with their neighbour to make `b` out of `a`.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that the user most probably meant, empty when none is near.
std::string nearest_name(std::string_view word, std::span<const std::string> names);

/// ` (did you mean 'NAME'?)`, or nothing when no name is near: to put behind the wrong word in an error text.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

}  // namespace vvr
