#pragma once

#include <cstdint>
#include <span>

#include "core/base/plane.h"
#include "core/fields/planes.h"
#include "core/media/frame.h"

namespace vvr::fields {

/// The usual deviation of each pixel from the empty scene, grey levels: camera noise, and more where leaves sway or
/// edges tremble. It is roughly the median deviation, taken from the quarter of the frames that deviate least (from the
/// third if the camera shakes), so that an object that is present most of the time doesn't count; from fewer frames
/// where an object stays even longer.
/// \param frames under the same light and, if the camera shakes, aligned
/// \param scene the empty scene, smoothed by `smooth` as the frames will be
/// \returns empty if there are too few frames
Plane<std::uint8_t> noise_of(std::span<const media::Frame> frames, const Planes& scene, double smooth,
                             bool shakes = false);

}  // namespace vvr::fields
