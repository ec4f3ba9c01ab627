#pragma once

#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/volume/volume.h"

namespace vvr::test {

/// The slow, obvious way to draw a volume: for each pixel walk along its ray in steps of `step`, ask the layout where
/// in the volume each point is, interpolate, and add up. Shares no code with the slicer but the layout's CPU map.
/// \returns premultiplied RGBA over `background`, top row first
Plane<glm::vec4> cast_rays(const volume::Volume& volume, const space::Layout& layout,
                           const scene::TransferFunction& transfer, const space::Camera& camera, Size picture,
                           const glm::dvec3& background, double step);

/// Where in C-space something lies that is seen at the centre of a pixel, `depth` along the view direction.
glm::dvec3 c_of_pixel(int i, int j, double depth, const space::Camera& camera, const space::Layout& layout,
                      Size picture);

/// Mean absolute difference of the colour channels in 1/255.
double mean_difference(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b);

/// The difference in 1/255 that only `share` of the colour values exceed.
double quantile_difference(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b, double share);

/// The largest difference of the colour channels in 1/255.
double max_difference(const Plane<glm::vec4>& a, const Plane<glm::vec4>& b);

/// The largest difference from an empty picture, which is white.
double max_contrast(const Plane<glm::vec4>& picture);

}  // namespace vvr::test
