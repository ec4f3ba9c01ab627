#include <optional>

#include "core/fields/filter.h"
#include "core/fields/illumination.h"
#include "core/fields/planes.h"

namespace vvr::fields {
namespace {

class Temporal final : public Filter {
  public:
    explicit Temporal(const FieldOptions& options) : illumination_(*options.illumination), norm_(*options.norm) {}

    Plane<std::uint8_t> operator()(const FilterInput& input) override {
        if (input.previous == nullptr) return Plane<std::uint8_t>(input.frame.grey.size());
        const IlluminationChange light =
            illumination_.compensates ? estimate_illumination(*input.previous, input.smooth) : IlluminationChange{};
        const std::optional<Planes> lit = illumination_.relit(*input.previous, input.smooth, light);
        return norm_for(norm_, input.smooth).difference(input.smooth, lit ? *lit : *input.previous);
    }

  private:
    const IlluminationRow& illumination_;
    const NormRow& norm_;
};

}  // namespace

std::unique_ptr<Filter> make_temporal(const FieldOptions& options) {
    return std::make_unique<Temporal>(options);
}

}  // namespace vvr::fields
