#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "core/error.h"
#include "core/fields/flow.h"

namespace vvr {
namespace {

constexpr std::array rows{
    FlowRow{"horn-schunck", "the paper's method", make_horn_schunck},
    FlowRow{"none", "no flow and no seeds", [](const FlowOptions&) { return std::unique_ptr<FlowMethod>{}; }},
};

}  // namespace

std::span<const FlowRow> flow_methods() {
    return rows;
}

std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options) {
    const auto row = std::ranges::find(rows, options.method, &FlowRow::name);
    if (row != rows.end()) return row->make(options);
    std::string names;
    for (const FlowRow& r : rows) names += fmt::format("{}{}", names.empty() ? "" : ", ", r.name);
    throw Error(ErrorKind::usage,
                fmt::format("--flow: there is no method \"{}\"; it is one of: {}", options.method, names));
}

}  // namespace vvr
