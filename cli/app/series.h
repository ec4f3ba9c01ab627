#pragma once

#include "cli/app/drawn.h"
#include "cli/app/observer.h"

namespace vvr::app {

/// Draws a series: one picture per brick of the clip, when the brick has entered the window. Picture j shows bricks j -
/// k + 1 to j; the first pictures show fewer, from the start of the horseshoe. Time scale and camera are the same in
/// all pictures. Memory depends only on the window.
/// \param sink called with each picture and its brick's number
/// \returns the last window's observation, with the frames, damage and events of the whole clip
Outcome render_series(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink);

}  // namespace vvr::app
