#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "cli/observe/observe.h"
#include "cli/plan/plan.h"
#include "core/annotation/lettering.h"
#include "core/annotation/objects.h"
#include "core/annotation/ruler.h"
#include "core/annotation/sheet.h"
#include "core/annotation/time_ticks.h"
#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/volume/brick.h"
#include "core/volume/layer.h"
#include "core/volume/volume.h"

namespace vvr::app {

/// What to draw beside the voxels of the volume, and where.
struct Composition {
    Framing framing;
    std::vector<volume::Brick> bricks;                    ///< of the volume, in layers
    std::vector<volume::CompressedIdle> compressed_idle;  ///< where time gets less room than average
    bool nothing_moves = false;                           ///< nothing of the volume is visible
    annotation::Objects objects;                          ///< that the picture shows
    std::vector<annotation::TimeTick> ticks;              ///< of the ruler; empty if it isn't shown
    std::vector<volume::Brick> pieces;      ///< the parts in which the volume is drawn; empty if it isn't shown
    std::int64_t first_piece = 0;           ///< number of the first piece, counted from the start of the clip
    std::int64_t layers = 0;                ///< layers that fill the whole of t_C
    int textures = 1;                       ///< number of pieces held in textures at the same time
    std::vector<glm::vec4> palette;         ///< colours of voxels that belong to an object or a time
    scene::Scene scene;                     ///< geometry in and around the volume
    bool frames_missing = false;            ///< some frames to be shown have no picture
    bool boxes = false;                     ///< Fig. 5: show boxes around the volume and its visible part
    std::optional<space::Camera> slices{};  ///< Fig. 5: the camera whose slices are shown
    annotation::Lettering lettering;        ///< flat text over the picture; empty if only a page shows it
};

/// Decides what a picture of an observation shows. Calls no OpenGL, and reads no file except the font.
Composition compose(const ComposePlan& plan, const Observation& seen);

/// The geometry that depends on the fields only.
/// \param composed with framing, bricks, ticks and objects set
scene::Scene scene_of(const ComposePlan& plan, const Observation& seen, const Composition& composed);

/// The colours of voxels that belong to an object or a time; empty if no voxel does.
std::vector<glm::vec4> palette_of(const LookPlan& look);

/// A clip of a few frames, and what a picture of it shows: the same kinds of things as a picture of the plan's clip.
struct Sample {
    Observation seen;
    Composition composed;
};

Sample compose_sample(const ComposePlan& plan);

/// The intervals without frames. Those between the requested parts are distinguished from losses of signal.
std::vector<annotation::TimeGap> explained_gaps(const ComposePlan& plan, const Observation& seen);

/// All text of a picture, with lines and portraits. Empty if there is no font.
/// \param composed complete except for the lettering and the scene
annotation::Lettering annotate(const ComposePlan& plan, const Observation& seen, const Composition& composed);

/// The number of ruler breaks that are marked at most.
inline constexpr std::size_t breaks_shown = 48;

}  // namespace vvr::app
