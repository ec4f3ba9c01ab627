#pragma once

#include "cli/app/composition.h"
#include "cli/app/observe.h"

namespace vvr::app {

/// What a picture of an observation shows. Calls no OpenGL, and touches no file but that of the font.
Composition compose(const Plan& plan, const Observation& seen);

/// The geometry that depends on the fields alone.
/// \param composed its framing, bricks, ticks and objects are known
scene::Scene scene_of(const Plan& plan, const Observation& seen, const Composition& composed);

/// The colours of voxels that have an identity, or of times; none where voxels need none.
std::vector<glm::vec4> palette_of(const Plan& plan);

}  // namespace vvr::app
