#pragma once

#include <vector>

#include "core/glance/objects.h"
#include "core/labels/lettering.h"
#include "core/labels/sheet.h"
#include "core/labels/time_ticks.h"

namespace vvr::glance {

/// An object's bar in the time strip.
struct StripBar {
    std::size_t event = 0;  ///< index in the list of events
    int row = 0;            ///< 0 = the lowest
};

/// Assigns rows to events, so that events in the same row don't overlap and are at least `apart` seconds apart.
/// \param order in which events get rows; events that don't fit into `rows` rows get no bar
std::vector<StripBar> strip_bars(std::span<const events::Event> events, std::span<const std::size_t> order, int rows,
                                 double apart);

/// An interval without objects, in seconds of the clip.
struct IdlePeriod {
    double begin = 0;
    double end = 0;
};

std::vector<IdlePeriod> idle_periods(std::span<const events::Event> events, double begin, double end);

/// The colours of the strip.
struct StripStyle {
    image::Rgba ink{};
    image::Rgba pale{};
    image::Rgba lines{};
    image::Rgba background{};
};

/// Draws the time strip: a bar per object over a linear time axis, thick while the object was stationary. Objects that
/// find no row are only counted.
/// \param found the changes that are no objects
/// \param begin, end seconds of the clip
/// \param nothing_moved the clip has no motion at all
void label_strip(const Objects& objects, const events::Findings& found, double begin, double end, bool nothing_moved,
                 const labels::Sheet& sheet, const StripStyle& style, labels::Lettering& lettering);

}  // namespace vvr::glance
