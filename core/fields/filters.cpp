#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "core/error.h"
#include "core/fields/filter.h"

namespace vvr {
namespace {

constexpr std::array rows{
    FilterRow{"difference", "what differs from the empty scene", {.reference = true, .colour = true}, make_difference},
};

}  // namespace

std::span<const FilterRow> filters() {
    return rows;
}

const FilterRow& find_filter(std::string_view name) {
    const auto row = std::ranges::find(rows, name, &FilterRow::name);
    if (row != rows.end()) return *row;
    std::string names;
    for (const FilterRow& r : rows) names += fmt::format("{}{}", names.empty() ? "" : ", ", r.name);
    throw Error(ErrorKind::usage, fmt::format("--filter: there is no filter \"{}\"; it is one of: {}", name, names));
}

}  // namespace vvr
