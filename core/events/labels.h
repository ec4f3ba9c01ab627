#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/events/event.h"
#include "core/events/patch.h"
#include "core/fields/label_run.h"

namespace vvr::events {

/// Which pixels of a field belong to which track, as runs of columns; a pixel that no run names belongs to none.
///
/// A track's event is known only when the clip has ended, because tracks are joined then. So a sink keeps the runs, and
/// looks the numbers up in `Event::tracks` afterwards; a number that no event has is that of something that turned out
/// to be none. Runs of a busy frame take about a hundredth of its field.
struct FrameLabels {
    Moment at;
    std::vector<fields::LabelRun> runs;
};

using LabelSink = std::function<void(const FrameLabels&)>;

/// Adds the pixels of a patch.
void add_runs(const Patch& patch, std::size_t track, FrameLabels& labels);

/// The place in the list of the event that each track became a part of; none for those of no event. Indexed by track.
std::vector<std::optional<std::size_t>> events_of_tracks(std::span<const Event> events);

}  // namespace vvr::events
