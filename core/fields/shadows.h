#pragma once

#include <cstdint>

#include "core/fields/planes.h"

namespace vvr {

/// Sets to 0 what is a cast shadow and not an object: there the empty scene is seen through, darker by the same share
/// in all channels and by nearly the same share as beside it, so that its texture is unchanged. Where the scene has no
/// texture a shadow can't be told from a dark thing, and nothing is removed.
/// \param empty the empty scene in the light of `frame`
void remove_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty);

}  // namespace vvr
