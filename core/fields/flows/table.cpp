#include <array>

#include "core/fields/choice.h"
#include "core/fields/flow.h"

namespace vvr {
namespace {

constexpr std::array rows{
    FlowRow{"horn-schunck", "the paper's method; --solver says how its equations are solved", make_horn_schunck},
    FlowRow{"dis", "OpenCV's dense inverse search", make_dis},
    FlowRow{"farneback", "OpenCV's polynomial expansion", make_farneback},
    FlowRow{"none", "no flow and no seeds", [](const FlowOptions&) { return std::unique_ptr<FlowMethod>{}; }},
};

}  // namespace

std::span<const FlowRow> flow_methods() {
    return rows;
}

std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options) {
    return choose("--flow", options.method, rows).make(options);
}

}  // namespace vvr
