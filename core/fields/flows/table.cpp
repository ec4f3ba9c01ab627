#include <algorithm>
#include <array>
#include <limits>

#include "core/base/setting.h"
#include "core/fields/flow.h"

namespace vvr::fields {
namespace {

constexpr std::array rows{
    FlowRow{"horn-schunck", "the paper's method; the solver says how its equations are solved", make_horn_schunck},
    FlowRow{"dis", "OpenCV's dense inverse search", make_dis},
    FlowRow{"farneback", "OpenCV's polynomial expansion", make_farneback},
    FlowRow{"none", "no flow and no seeds", [](const FlowOptions&) { return std::unique_ptr<FlowMethod>{}; }, true},
};

// In a short clip the whole frame costs little, and a sequence without an empty scene, such as a benchmark's, needs it.
constexpr std::int64_t few_frames = 64;

constexpr std::array areas{
    FlowArea{"auto", "the whole frame in clips of up to 64 frames, else where something moves", few_frames},
    FlowArea{"moving", "only near what is shown and changes", 0},
    FlowArea{"all", "the whole frame", std::numeric_limits<std::int64_t>::max()},
};

}  // namespace

std::span<const FlowArea> flow_areas() {
    return areas;
}

bool is_whole_frame(const FlowOptions& options, std::int64_t frames) {
    const std::int64_t most = options.area->whole_up_to;
    return frames > 0 ? frames <= most : most == std::numeric_limits<std::int64_t>::max();
}

bool has_flow(const FlowOptions& options) {
    return !options.method->is_none;
}

const FlowRow& no_flow() {
    return *std::ranges::find_if(rows, &FlowRow::is_none);
}

std::span<const FlowRow> flow_methods() {
    return rows;
}

std::unique_ptr<FlowMethod> make_flow(const FlowOptions& options) {
    return options.method->make(options);
}

const FlowArea& row_of(Name<FlowArea> name) {
    return choose("flow-area", name.text, flow_areas());
}

const FlowRow& row_of(Name<FlowRow> name) {
    return choose("flow", name.text, flow_methods());
}

}  // namespace vvr::fields
