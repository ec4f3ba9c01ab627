#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/condition/condition.h"
#include "core/tracking/event.h"
#include "core/tracking/event_options.h"
#include "core/tracking/tracklet.h"

namespace vvr::tracking {

/// Consecutive frames without a gap, of one view of the camera.
struct Stretch {
    Moment first;
    Moment last;
    std::size_t view = 0;
};

/// The observed part of a clip.
struct Span {
    Size field;
    Moment first;
    Moment last;
    std::vector<Stretch> stretches;            ///< a single one where there is no gap
    std::vector<PixelBox> overlays;            ///< the camera's clocks
    std::vector<condition::Interval> damaged;  ///< when pictures were damaged

    double seconds_per_frame() const {
        return (last.seconds - first.seconds) / std::max(1.0, static_cast<double>(last.frame - first.frame));
    }
};

/// Makes events of all tracklets of a clip: joins the tracklets of each object, classifies the objects, and drops what
/// is no event (fragments, flicker, ghosts).
/// A stationary object that nobody saw move is said to have been left or taken only with enough evidence; otherwise it
/// is a change.
Findings conclude(std::vector<Tracklet> tracklets, const Span& span, const EventOptions& options);

}  // namespace vvr::tracking
