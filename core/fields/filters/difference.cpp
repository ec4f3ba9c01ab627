#include "core/fields/filter.h"

namespace vvr::fields {
namespace {

class Difference final : public Filter {
    Plane<std::uint8_t> operator()(const FilterInput& input) override { return input.object; }
};

}  // namespace

std::unique_ptr<Filter> make_difference(const FieldOptions&) {
    return std::make_unique<Difference>();
}

}  // namespace vvr::fields
