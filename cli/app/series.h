#pragma once

#include "cli/app/drawn.h"
#include "cli/app/observer.h"

namespace vvr::app {

/// A series: one picture for each brick of the clip, drawn when the brick has entered the window. Picture j shows
/// bricks j - k + 1 to j; as long as fewer than k have entered, the horseshoe fills from its beginning. Time has one
/// scale and the camera one place in all pictures. Memory depends on the window alone.
/// \param sink takes each picture with its brick's number
/// \returns what is known of the last window, with the frames, the damage and the events of the whole clip
Outcome render_series(const Plan& plan, fields::FieldSource& source, Observer& observer, const PictureSink& sink);

}  // namespace vvr::app
