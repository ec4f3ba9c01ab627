#pragma once

#include <cstdint>

#include "core/base/plane.h"

namespace vvr::fields {

/// Copies the changed part of `object` to `changed`: tiles of 8 × 8 pixels that differ between two frames by more than
/// the camera's noise, and their neighbours. The noise level comes from the quiet tiles of the same frames.
/// \param other, here the frames, smoothed; `object` belongs to `here`
void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed);

}  // namespace vvr::fields
