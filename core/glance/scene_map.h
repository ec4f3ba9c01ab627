#pragma once

#include "core/base/plane.h"
#include "core/glance/objects.h"
#include "core/labels/lettering.h"

namespace vvr::glance {

/// Draws the scene as the camera sees it, and where each object went: its path with a number where it came from and an
/// arrow where it went, a dot where it stood or was left. Those that are too many to be told apart are thin grey lines.
/// \param scene empty of objects where there is such a picture
/// \param field the size that places of events are in
/// \param box of the map in the picture
/// \param text size of the numbers
/// \param background towards which the scene is paled
void draw_map(const Objects& objects, const Plane<Bgr>& scene, Size field, const PixelBox& box, int text,
              const image::Rgba& background, labels::Lettering& lettering);

}  // namespace vvr::glance
