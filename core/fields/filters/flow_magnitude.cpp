#include <algorithm>
#include <cmath>

#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

// The range ends at about ten pixels per frame, more than CCTV shows at its usual field size.
constexpr float levels_a_pixel = 24;

class FlowMagnitude final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        Plane<std::uint8_t> result(input.frame.grey.size());
        if (input.flow.u.empty()) return result;
        std::ranges::transform(input.flow.u.pixels(), input.flow.v.pixels(), result.pixels().begin(),
                               [](float u, float v) {
                                   const float level = levels_a_pixel * std::sqrt(u * u + v * v);
                                   return static_cast<std::uint8_t>(std::lround(std::min(level, 255.F)));
                               });
        return result;
    }
};

}  // namespace

std::unique_ptr<Filter> make_flow_magnitude(const FieldOptions&) {
    return std::make_unique<FlowMagnitude>();
}

}  // namespace vvr::fields
