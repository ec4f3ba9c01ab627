#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

class Luminance final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override { return input.frame.grey; }
};

}  // namespace

std::unique_ptr<Filter> make_luminance(const FieldOptions&) {
    return std::make_unique<Luminance>();
}

}  // namespace vvr::fields
