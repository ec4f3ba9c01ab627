#pragma once

#include "tests/scene/scene.h"

// Scenes as other cameras see them.
namespace vvr::generator {

/// A scene seen by a camera that shakes by up to six pixels to each side after a still first tenth. The truth is that
/// of the still camera.
Scene make_shaken(const Scene& still);

/// Every `every`th frame of a scene, from frame `first` on, at a rate that is as much lower.
Scene make_thinned(const Scene& whole, int every, int first = 0);

}  // namespace vvr::generator
