#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/annotation/lettering.h"
#include "core/annotation/objects.h"
#include "core/annotation/sheet.h"
#include "core/annotation/time_ticks.h"
#include "core/condition/condition.h"
#include "core/volume/owners.h"
#include "core/volume/volume.h"

namespace vvr::annotation {

/// An interval of the clip, in seconds.
struct Period {
    double begin = 0;
    double end = 0;

    bool overlaps(const Period& other) const { return begin < other.end && other.begin < end; }
};

/// The rest of the clip, in order.
/// \param busy periods in any order; they may overlap
std::vector<Period> idle_periods(std::vector<Period> busy, double begin, double end);

/// The times at which somebody may have been there, although no object was: where something compact differs from the
/// empty scene for as long as an event lasts at least, and where there are no frames.
std::vector<Period> unexplained_periods(const volume::Volume& volume, const volume::VoxelStyleLookup& identify);

/// An object's bar in the time strip.
struct StripBar {
    std::size_t event = 0;  ///< index in the list of events
    int row = 0;            ///< 0 = the lowest
};

/// Chooses the events that get a bar, and their rows: events in the same row don't overlap and are at least `apart`
/// seconds apart. An event gets a bar if there is a row for it beside all events before it in `order`. Rows are
/// assigned by the events' first frames.
///
/// \returns the bars in the order of the events' first frames
std::vector<StripBar> strip_bars(std::span<const tracking::Event> events, std::span<const std::size_t> order, int rows,
                                 double apart);

/// The colours of the strip.
struct StripStyle {
    image::Rgba ink{};
    image::Rgba pale{};
    image::Rgba lines{};
    image::Rgba background{};
};

/// What a time strip shows besides objects.
struct StripContent {
    const tracking::Findings& found;      ///< changes that are no objects
    std::span<const Period> unexplained;  ///< other times at which somebody may have been there
    std::span<const Period> not_chosen;   ///< when objects were there whose events weren't chosen
    double begin = 0;                     ///< seconds of the clip
    double end = 0;
    bool nothing_moved = false;                        ///< the clip has no motion at all
    std::span<const condition::Interval> intervals{};  ///< what the recording itself did, in order
};

/// Draws the time strip: a bar per object over a linear time axis, striped while the object stayed in its place, thick
/// while it was left behind, dashed while it was gone, and where there was nobody. Objects that find no row are only
/// counted. \returns the indices of the events that have a bar with a number
std::vector<std::size_t> label_strip(const Objects& objects, const StripContent& content,
                                     const annotation::Sheet& sheet, const StripStyle& style,
                                     annotation::Lettering& lettering);

}  // namespace vvr::annotation
