#pragma once

#include "cli/app/compose.h"
#include "cli/app/observe.h"
#include "cli/app/plan.h"
#include "core/page/page.h"

namespace vvr::app {

/// What a page draws over its picture: where moments, portraits and the map are in it.
/// \param composed with framing, ticks and objects
page::Overlay overlay_of(const Plan& plan, const Observation& seen, const Composition& composed);

}  // namespace vvr::app
