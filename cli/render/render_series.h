#pragma once

#include <cstdint>

#include "cli/render/render_clip.h"

namespace vvr {

/// The window that slides over a clip (§7): k bricks of as many layers each.
struct SlidingWindow {
    int bricks = 8;  ///< k
    std::int64_t brick_layers = 1;
    std::int64_t step = 1;  ///< frames per layer

    std::int64_t layers() const { return bricks * brick_layers; }
    std::int64_t brick_frames() const { return brick_layers * step; }
    std::int64_t frames() const { return layers() * step; }
};

/// The window of a job's series. A brick is as long as the job says; by default 10 s, or less
/// if k bricks of that length are longer than the clip.
/// \throws Error usage when bricks are in seconds and the rate is unknown
SlidingWindow sliding_window(const RenderJob& job, const FieldSource& source);

/// A series: one picture for each brick of the clip, drawn when the brick has entered the window. Picture j shows
/// bricks j - k + 1 to j; as long as fewer than k have entered, the horseshoe fills from its beginning. Time has one
/// scale and the camera one place in all pictures. Memory depends on the window alone.
/// \param sink takes each picture with its brick's number, on any thread
/// \returns the last picture's report, with the frames and damage of the whole clip
RenderReport render_series(const RenderJob& job, FieldSource& source, const FrameProgress& progress,
                           const PictureSink& sink);

}  // namespace vvr
