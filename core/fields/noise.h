#pragma once

#include <cstdint>
#include <span>

#include "core/fields/planes.h"
#include "core/video/frame.h"

namespace vvr::fields {

/// By how many grey levels each pixel of the empty scene usually differs from itself: camera noise, and more where
/// leaves sway or edges tremble. It is about the median of the differences; learnt from the third of the frames that
/// differ least, so that whoever is there for most of the time doesn't count, and from fewer of them where something
/// lies for even longer. \param frames in one light and, if the camera shakes, aligned \param scene the empty scene,
/// smoothed by `smooth` as the frames will be \returns empty where there are too few frames to learn from
Plane<std::uint8_t> noise_of(std::span<const video::Frame> frames, const Planes& scene, double smooth);

}  // namespace vvr::fields
