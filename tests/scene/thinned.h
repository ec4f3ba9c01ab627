#pragma once

#include "tests/scene/scene.h"

namespace vvr::generator {

/// Every `every`th frame of a scene, from frame `first` on, at a rate that is as much lower.
Scene make_thinned(const Scene& whole, int every, int first = 0);

}  // namespace vvr::generator
