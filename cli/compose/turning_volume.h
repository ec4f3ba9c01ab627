#pragma once

#include "cli/compose/compose.h"
#include "core/base/json_text.h"

namespace vvr::app {

/// The volume that the page of a composition turns, as its script reads it (TurningVolume in core/web/page/data.js).
/// Null for a stream, without objects, or if the user wants none.
Json turning_volume(const ComposePlan& plan, const Observation& seen, const Composition& composed);

}  // namespace vvr::app
