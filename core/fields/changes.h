#pragma once

#include <cstdint>

#include "core/base/plane.h"

namespace vvr::fields {

/// Copies to `changed` what of `object` lies in tiles of 8 × 8 pixels that differ between two frames by more than the
/// camera's noise, or next to one. The noise is learnt from the quiet tiles of the same frames.
/// \param other, here the frames, smoothed; the object is that of `here`
void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed);

}  // namespace vvr::fields
