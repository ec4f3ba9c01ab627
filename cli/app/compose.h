#pragma once

#include "cli/app/composition.h"
#include "cli/app/observe.h"

namespace vvr::app {

/// Decides what a picture of an observation shows. Calls no OpenGL, and reads no file except the font.
Composition compose(const Plan& plan, const Observation& seen);

/// The geometry that depends on the fields only.
/// \param composed with framing, bricks, ticks and objects set
scene::Scene scene_of(const Plan& plan, const Observation& seen, const Composition& composed);

/// The colours of voxels that belong to an object or a time; empty if no voxel does.
std::vector<glm::vec4> palette_of(const Plan& plan);

}  // namespace vvr::app
