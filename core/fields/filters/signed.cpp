#include <algorithm>

#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

class Signed final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        Plane<std::uint8_t> result(input.object.size());
        std::ranges::transform(input.object.pixels(), input.darker.pixels(), result.pixels().begin(),
                               [](std::uint8_t value, std::uint8_t darker) {
                                   const int half = (value + 1) / 2;
                                   const int side = darker != 0 ? std::max(sign_middle - half, 1)
                                                                : std::min(sign_middle + half, 255);
                                   return static_cast<std::uint8_t>(value == 0 ? 0 : side);
                               });
        return result;
    }
};

}  // namespace

std::unique_ptr<Filter> make_signed(const FieldOptions&) {
    return std::make_unique<Signed>();
}

}  // namespace vvr::fields
