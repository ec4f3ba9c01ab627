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

constexpr std::array areas{
    FlowArea{"auto", "all of a clip of up to 64 frames, what moves in a longer one"},
    FlowArea{"moving", "only about what is shown and changes"},
    FlowArea{"all", "the whole frame"},
};

}  // namespace

std::span<const FlowArea> flow_areas() {
    return areas;
}

std::string resolved_area(const std::string& area, std::int64_t frames) {
    constexpr std::int64_t few = 64;
    if (area != "auto") return area;
    return frames > 0 && frames <= few ? "all" : "moving";
}

std::span<const FlowRow> flow_methods() {
    return rows;
}

std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options) {
    return choose("--flow", options.method, rows).make(options);
}

}  // namespace vvr
