#pragma once

#include <cstddef>

#include "cli/app/composition.h"
#include "cli/app/observe.h"

namespace vvr::app {

/// All text of a picture, with lines and portraits. Empty if there is no font.
/// \param composed complete except for the lettering and the scene
labels::Lettering annotate(const Plan& plan, const Observation& seen, const Composition& composed);

/// The number of ruler breaks that are marked at most.
inline constexpr std::size_t breaks_shown = 48;

}  // namespace vvr::app
