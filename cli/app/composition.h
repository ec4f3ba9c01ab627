#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/app/framing.h"
#include "core/bricks/brick.h"
#include "core/bricks/owners.h"
#include "core/bricks/volume.h"
#include "core/glance/objects.h"
#include "core/labels/lettering.h"
#include "core/labels/time_ticks.h"
#include "core/scene/scene.h"

namespace vvr::app {

/// What is to be drawn beside the voxels of the volume, and where.
struct Composition {
    Framing framing;
    std::vector<bricks::Brick> bricks;             ///< of the volume, in layers
    std::vector<bricks::CompressedIdle> squeezed;  ///< where time has less room than in the mean
    bool still = false;                            ///< nothing of the volume is visible
    glance::Objects objects;                       ///< that the picture tells of
    std::vector<labels::TimeTick> ticks;           ///< of the ruler; none where it isn't shown
    std::vector<bricks::Brick> pieces;             ///< in which the volume is drawn; none where it isn't shown
    std::int64_t first_piece = 0;                  ///< number of the first of them, counted from the clip's
    std::int64_t layers = 0;                       ///< that fill all of t_C
    int textures = 1;                              ///< that hold pieces at a time
    std::vector<glm::vec4> palette;                ///< of voxels that have an identity, or of times
    scene::Scene scene;                            ///< geometry around and in the volume
    bool frames_missing = false;                   ///< some of the frames to be shown came without a picture
    bool boxes = false;                            ///< Fig. 5: around the volume and what is visible of it
    std::optional<space::Camera> slices{};         ///< Fig. 5: whose slices are shown
    labels::Lettering lettering;                   ///< flat, over all
};

}  // namespace vvr::app
