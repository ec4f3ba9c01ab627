#pragma once

#include <algorithm>
#include <ranges>
#include <string>
#include <string_view>
#include <vector>

namespace vvr {

/// \throws Error usage: that `option` has no value `found`, which of `names` may be meant, and what all of them are
[[noreturn]] void no_such_choice(std::string_view option, std::string_view found,
                                 const std::vector<std::string_view>& names, std::string_view or_else);

/// The row of a table whose name is `found`. `or_else` tells what else the option takes.
/// \throws Error usage when there is none
template <class Rows>
const auto& choose(std::string_view option, std::string_view found, const Rows& rows, std::string_view or_else = {}) {
    const auto row = std::ranges::find(rows, found, [](const auto& r) { return r.name; });
    if (row != rows.end()) return *row;
    std::vector<std::string_view> names;
    for (const auto& r : rows) names.push_back(r.name);
    no_such_choice(option, found, names, or_else);
}

}  // namespace vvr
