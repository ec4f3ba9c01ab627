#pragma once

#include <cstddef>

#include "cli/app/composition.h"
#include "cli/app/observe.h"

namespace vvr::app {

/// All text on a picture, and what belongs to it. Empty where there is no font.
/// \param composed all but this and the scene
labels::Lettering letter(const Plan& plan, const Observation& seen, const Composition& composed);

/// Breaks of the ruler that are marked.
inline constexpr std::size_t breaks_shown = 48;

}  // namespace vvr::app
