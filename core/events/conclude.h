#pragma once

#include <algorithm>
#include <vector>

#include "core/events/event.h"
#include "core/events/event_options.h"
#include "core/events/tracklet.h"
#include "core/fields/planes.h"

namespace vvr::events {

/// Frames without a gap between them.
struct Stretch {
    Moment first;
    Moment last;
};

/// What was looked at.
struct Span {
    Size field;
    Moment first;
    Moment last;
    std::vector<Stretch> stretches;  ///< one where there is no gap

    double seconds_per_frame() const {
        return (last.seconds - first.seconds) / std::max(1.0, static_cast<double>(last.frame - first.frame));
    }
};

/// Makes events of all tracklets of a clip: joins those of one object, tells what kind each is, and leaves out what is
/// none: pieces, flicker, ghosts.
/// \param scene the empty scene; may be empty, and then nothing counts as taken
std::vector<Event> conclude(std::vector<Tracklet> tracklets, const Span& span, const fields::Planes& scene,
                            const EventOptions& options);

}  // namespace vvr::events
