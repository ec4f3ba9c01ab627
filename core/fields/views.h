#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/media/frame.h"

namespace vvr::fields {

/// Whether the camera was in its infrared mode: the frame has no colours, and it isn't dark.
bool shows_infrared(const media::Frame& frame);

/// Divides frames by what the camera showed: its views, and its infrared mode. Each group keeps the order of the
/// frames, and the largest comes first. Left out are frames without a picture, and groups too small for an empty scene.
/// \returns all frames as one group if nothing else would be left
std::vector<std::vector<media::Frame>> by_view(std::vector<media::Frame> frames);

/// Whether an empty scene is what the camera showed: at least half of the frames show it.
bool is_view_of(const Plane<std::uint8_t>& scene, std::span<const media::Frame> frames);

}  // namespace vvr::fields
