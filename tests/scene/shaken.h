#pragma once

#include "tests/scene/scene.h"

namespace vvr::generator {

/// A scene seen by a camera that shakes by up to six pixels to each side after a still first tenth. The truth is that
/// of the still camera.
Scene make_shaken(const Scene& still);

}  // namespace vvr::generator
