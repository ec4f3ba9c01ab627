#pragma once

#include <cstdint>

#include "core/fields/planes.h"

namespace vvr {

/// Sets to 0 what is a cast shadow and not an object: there the scene is darker by the same share in all channels, down
/// to half (after Horprasert, Harwood and Davis, ICCV 1999). Does nothing to frames without colour, in which a shadow
/// can't be told from a dark thing.
/// \param empty the empty scene in the light of `frame`
void remove_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty);

}  // namespace vvr
