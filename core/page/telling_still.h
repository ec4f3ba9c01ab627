#pragma once

#include <optional>
#include <span>

#include "core/events/event.h"
#include "core/page/stills.h"

namespace vvr::page {

/// The still that tells most of a clip: of what was left behind, else of what was taken, of what stood for longest, of
/// what was there for longest; with a frame around it. Without events it is the one in the middle.
/// \param field size of the field, whose pixels are the unit of events
/// \returns nothing where there are no stills
std::optional<Still> best_still(std::span<const Still> stills, std::span<const events::Event> events, Size field);

}  // namespace vvr::page
