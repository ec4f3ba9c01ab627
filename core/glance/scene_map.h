#pragma once

#include "core/base/plane.h"
#include "core/glance/objects.h"
#include "core/labels/lettering.h"

namespace vvr::glance {

/// Draws a map: the scene, and each object's path with its number at the start, an arrow at the end, and a dot where it
/// was stationary. Paths beyond the first few, which would be indistinguishable, are thin grey lines.
/// \param scene the empty scene if known, else a frame
/// \param field size of the fields in which events have their positions
/// \param box of the map in the picture
/// \param text size of the numbers in pixels
/// \param background the scene is blended towards it
void draw_map(const Objects& objects, const Plane<Bgr>& scene, Size field, const PixelBox& box, int text,
              const image::Rgba& background, labels::Lettering& lettering);

}  // namespace vvr::glance
