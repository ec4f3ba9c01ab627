#pragma once

#include <cstddef>
#include <vector>

#include "core/annotation/lettering.h"
#include "core/annotation/objects.h"
#include "core/base/plane.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::annotation {

/// Draws a map: the scene, and each object's path with its number at the start, an arrow at the end, and a dot where it
/// was stationary. Paths beyond the first few, which would be indistinguishable, are thin grey lines.
/// \param scene the empty scene if known, else a frame
/// \param field size of the fields in which events have their positions
/// \param box of the map in the picture
/// \param text size of the numbers in pixels
/// \param background the scene is blended towards it
/// \returns the indices of the events with a number on the map
std::vector<std::size_t> draw_map(const Objects& objects, const Plane<Bgr>& scene, Size field, const PixelBox& box,
                                  int text, const image::Rgba& background, annotation::Lettering& lettering);

/// The largest box for the map: in the open middle of a horseshoe, with the frame's shape, and clear of the volume.
/// Empty if there is none, as with the layout `box`.
/// \param area of the picture that may be used
/// \param aspect a frame's width divided by its height
PixelBox map_box(const space::Layout& layout, const space::Camera& camera, Size picture, const PixelBox& area,
                 double aspect);

}  // namespace vvr::annotation
