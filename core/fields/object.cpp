#include "core/fields/object.h"

#include "core/fields/choice.h"

namespace vvr {

ObjectFinder::ObjectFinder(const FieldOptions& options, int threshold, const Reference& reference,
                           const Plane<std::uint8_t>& region)
    : illumination_(choose("--illumination", options.illumination, illuminations())),
      clean_{.threshold = threshold, .gain = 2, .min_area = options.min_area},
      region_(region),
      reference_(smoothed(reference.grey, reference.colour, options.smooth)) {
    if (options.reference == "running") running_.emplace(reference_);
}

Plane<std::uint8_t> ObjectFinder::compare(const Planes& frame, const Reference& reference) const {
    Plane<std::uint8_t> object = largest_difference(frame, illumination_.relit(reference, frame));
    clean(object, clean_, region_);
    return object;
}

Plane<std::uint8_t> ObjectFinder::find(const Planes& frame) const {
    return compare(frame, reference_);
}

Plane<std::uint8_t> ObjectFinder::find_and_adapt(const Planes& frame) {
    Plane<std::uint8_t> object = compare(frame, running_->now());
    running_->adapt(frame, object, illumination_.compensates ? light_between(running_->now(), frame) : Light{});
    return object;
}

}  // namespace vvr
