#pragma once

#include <vector>

#include "core/events/event.h"
#include "core/events/event_options.h"
#include "core/events/tracklet.h"
#include "core/fields/planes.h"

namespace vvr {

/// What was looked at.
struct Span {
    Size field;
    Moment first;
    Moment last;
};

/// Makes events of all tracklets of a clip: joins those of one object, tells what kind each is, and leaves out what is
/// none: pieces, flicker, ghosts.
/// \param scene the empty scene; may be empty, and then nothing counts as taken
std::vector<Event> conclude(std::vector<Tracklet> tracklets, const Span& span, const Planes& scene,
                            const EventOptions& options);

}  // namespace vvr
