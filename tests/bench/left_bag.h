#pragma once

#include <string>

#include "core/bricks/volume.h"

namespace vvr::bench {

/// The volume of the left-bag scene, 384x288x1600 voxels, seen through a filter, with the seeds and the flow that `vvr
/// render` wants of it. All 1600 layers are kept, as in the paper. \param scale of each side of it; less than 1 is for
/// trying whether all works
bricks::Volume left_bag_volume(const std::string& filter, double scale = 1);

/// The share of the voxels that aren't 0.
double occupied_share(const bricks::Volume& volume);

}  // namespace vvr::bench
