#include <algorithm>

#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

class Hull final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        Plane<std::uint8_t> result(input.object.size());
        std::ranges::transform(input.object.pixels(), result.pixels().begin(),
                               [](std::uint8_t p) { return static_cast<std::uint8_t>(p == 0 ? 0 : 255); });
        return result;
    }
};

}  // namespace

std::unique_ptr<Filter> make_hull(const FieldOptions&) {
    return std::make_unique<Hull>();
}

}  // namespace vvr::fields
