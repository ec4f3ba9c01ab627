#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "core/events/event.h"

namespace vvr::events {

/// Small events that crowd one part of the picture: a screen, a flag, a far road, pieces of what stands there.
struct Clutter {
    std::int64_t count = 0;  ///< of all scraps
    PixelBox box;            ///< of those in the part, field pixels
    Moment at;               ///< when one of them is seen
};

/// A scrap is an event that never leaves an eighth of the picture's long side, both ways. Scraps dominate where there
/// are a dozen or more, they are half of all events or more, and half of them or more lie in one ninth of the picture,
/// a third of its width and height.
/// \returns nothing where they do not
std::optional<Clutter> find_clutter(std::span<const Event> events, Size field);

}  // namespace vvr::events
