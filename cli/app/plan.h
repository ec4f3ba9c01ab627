#pragma once

#include <cstdint>

#include "cli/app/job.h"
#include "core/fields/field_source.h"

// How frames become layers, and layers bricks and textures.
namespace vvr::app {

/// Clips of up to so many seconds have even time, unless busy time is asked for.
inline constexpr double short_recording = 120;

/// Whether a clip is that short, as far as its header tells.
bool is_short_recording(const fields::FieldSource& source);

/// The frames that each layer takes, from what the container says of the clip's length; 0 = unknown.
std::int64_t planned_step(const BrickOptions& bricks, std::int64_t frames);

/// The textures that there are at a time for pieces of bricks. In a single picture each piece is drawn but once: one
/// texture is filled while another is drawn.
int textures_of(const Products& products, int pieces);

/// The window that slides over a clip (§7): k bricks of the same number of layers.
struct SlidingWindow {
    int bricks = 8;  ///< k
    std::int64_t brick_layers = 1;
    std::int64_t step = 1;  ///< frames per layer

    std::int64_t layers() const { return bricks * brick_layers; }
    std::int64_t brick_frames() const { return brick_layers * step; }
    std::int64_t frames() const { return layers() * step; }
};

/// The window of a series. A brick is as long as the options say; by default 10 s, or less if k bricks of that length
/// are longer than the clip.
/// \throws Error usage when bricks are in seconds and the rate is unknown
SlidingWindow sliding_window(const BrickOptions& bricks, const fields::FieldSource& source);

/// What a render is going to do, if the clip has as many frames as its container says.
struct Plan {
    std::int64_t frames = 0;  ///< 0 = unknown
    std::int64_t step = 1;    ///< frames per layer
    std::int64_t layers = 0;
    std::int64_t bricks = 0;
    std::int64_t bytes = 0;  ///< estimate of the most memory that it can take, with something everywhere
};

Plan make_plan(const RenderJob& job, const Products& products, const fields::FieldSource& source);

/// \throws Error limit when the machine has less memory than that, where the system would kill the program half way
void check_memory(const Plan& plan);

}  // namespace vvr::app
