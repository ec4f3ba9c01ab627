#pragma once

#include <cstdint>

#include "core/base/plane.h"
#include "core/bricks/sparse_plane.h"
#include "core/fields/values.h"

namespace vvr::bricks {

/// One layer of the volume: of each pixel what its values in `frames` consecutive frames join to, the strongest one
/// where they are strengths.
struct Layer {
    std::int64_t first_frame = 0;  ///< index in the clip
    std::int64_t last_frame = 0;
    std::int64_t frames = 0;
    double pts = 0;            ///< seconds, of its first frame
    double last_pts = 0;       ///< seconds, of its last frame
    std::int64_t missing = 0;  ///< of the frames, those that never came
    std::int64_t moving = 0;   ///< of the frames, those in which something moves, where that is told
    SparsePlane scalar;
    Plane<Bgr> colour;  ///< of the frame that gave the scalar; empty unless colours are added
    OwnerPlane owner;   ///< in that frame; empty unless owners are kept
};

/// Joins a layer with the one after it; each voxel keeps the colour and the owner of the greater value, the first of
/// two alike. \param values that say how two values join
void join(Layer& layer, const Layer& next, fields::Values values = fields::Values::strength);

}  // namespace vvr::bricks
