#include "core/fields/field_source.h"

#include <utility>

#include "core/fields/filter.h"
#include "core/fields/flow.h"

namespace vvr::fields {

ClipFields::ClipFields(std::unique_ptr<video::FrameSource> clip, FieldOptions options)
    : clip_(std::move(clip)), options_(std::move(options)) {}

FieldSummary ClipFields::read(const FieldNeeds& needs, const FieldSink& sink) {
    if (std::exchange(begun_, true)) clip_->rewind();
    FieldOptions options = options_;
    options.flow.every = needs.every;
    options.flow.every_frame = needs.flow_of_every_frame;
    const bool shown = options.filter->traits.flow || (options.second != nullptr && options.second->traits.flow);
    if (!needs.seeds && !needs.flow && !needs.flow_of_every_frame && !shown) options.flow.method = no_flow();
    return compute_fields(*clip_, options, sink, needs.scene);
}

}  // namespace vvr::fields
