#include "core/fields/object.h"

#include "core/choice.h"
#include "core/fields/blobs.h"
#include "core/fields/settings.h"
#include "core/fields/shadows.h"

namespace vvr {

ObjectFinder::ObjectFinder(const FieldOptions& options, int threshold, const Reference& reference,
                           const Plane<std::uint8_t>& region)
    : illumination_(choose(setting::illumination.name, options.illumination, illuminations())),
      clean_{.threshold = threshold, .gain = 2},
      min_area_(options.min_area),
      shadows_(options.shadows),
      region_(region),
      reference_(smoothed(reference.grey, reference.colour, options.smooth)) {
    const ReferenceRow* const row = find_reference(options.reference);
    if (row != nullptr && row->adapts) running_.emplace(reference_);
}

Light ObjectFinder::light_of(const Planes& frame, const Reference& reference) const {
    return illumination_.compensates ? light_between(reference, frame) : Light{};
}

Plane<std::uint8_t> ObjectFinder::compare(const Planes& frame, const Reference& reference, const Light& light) const {
    Planes room;
    const Planes& empty = illumination_.relit(reference, frame, light, room);
    Plane<std::uint8_t> object = largest_difference(frame, empty);
    clean(object, clean_, region_);
    if (!shadows_) remove_shadows(object, frame, empty);
    remove_small_blobs(object, min_area_);
    return object;
}

Plane<std::uint8_t> ObjectFinder::find(const Planes& frame) const {
    return compare(frame, reference_, light_of(frame, reference_));
}

Plane<std::uint8_t> ObjectFinder::find_and_adapt(const Planes& frame) {
    const Light light = light_of(frame, running_->now());
    Plane<std::uint8_t> object = compare(frame, running_->now(), light);
    running_->adapt(frame, object, light);
    return object;
}

}  // namespace vvr
