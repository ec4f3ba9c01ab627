#pragma once

#include "core/bricks/volume.h"

namespace vvr::bench {

/// A volume of which the left `share` of each frame is lit.
bricks::Volume lit_volume(Size size, int frames, double share, bool coloured = false);

}  // namespace vvr::bench
