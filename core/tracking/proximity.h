#pragma once

#include <cstdint>
#include <optional>

#include "core/tracking/event.h"
#include "core/tracking/tracklet.h"

// Where objects were at a moment, and which of them were near each other.
namespace vvr::tracking {

/// The object's box at a moment; nothing where it was not seen then.
std::optional<PixelBox> box_at(const Tracklet& object, double seconds, std::int64_t frame);

/// Whether `piece` is a fragment of `whole`: inside its box for most of its own time.
bool is_fragment_of(const Tracklet& piece, const Tracklet& whole);

/// Whether an object with this box is within its own width, and half its height, of a place. False without a box.
bool is_near(const std::optional<PixelBox>& box, const PixelBox& place);

/// Whether the bearer was beside the thing's place just before or after it appeared.
bool was_beside(const Tracklet& bearer, const Tracklet& thing, double seconds_per_frame);

/// Whether an object can have brought or taken a thing: whoever takes a thing comes from elsewhere, and whoever
/// leaves one goes elsewhere. Somebody who stood there only uncovers the place, and somebody who ends there is the
/// thing.
bool can_carry(const Tracklet& bearer, const Tracklet& thing, EventKind kind, Size field);

/// The moment from which a thing was alone: when its owner last went a length away from it, or had gone.
std::optional<Moment> alone_since(const Event& thing, const Event& owner, double length);

}  // namespace vvr::tracking
