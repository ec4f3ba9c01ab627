#include <algorithm>

#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

// Before the first frame nothing was covered.
class Bands final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        Plane<std::uint8_t> result(input.object.size());
        const Plane<std::uint8_t> nothing(input.previous_object == nullptr ? input.object.size() : Size{});
        const Plane<std::uint8_t>& before = input.previous_object == nullptr ? nothing : *input.previous_object;
        std::ranges::transform(input.object.pixels(), before.pixels(), result.pixels().begin(),
                               [](std::uint8_t now, std::uint8_t then) {
                                   return static_cast<std::uint8_t>(band_of(then != 0, now != 0));
                               });
        return result;
    }
};

}  // namespace

std::unique_ptr<Filter> make_bands(const FieldOptions&) {
    return std::make_unique<Bands>();
}

}  // namespace vvr::fields
