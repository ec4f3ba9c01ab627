#pragma once

#include <vector>

#include "core/glance/objects.h"
#include "core/labels/lettering.h"
#include "core/labels/sheet.h"
#include "core/labels/time_ticks.h"

namespace vvr::glance {

/// The bar of an object in a strip of times.
struct StripBar {
    std::size_t event = 0;  ///< its place in the list
    int row = 0;            ///< 0 = the lowest
};

/// Gives the events rows so that no two in one row are there at the same time, nor nearer to each other than `apart`
/// seconds.
/// \param order in which they are given rows; those that find none in `rows` rows get no bar
std::vector<StripBar> strip_bars(std::span<const events::Event> events, std::span<const std::size_t> order, int rows,
                                 double apart);

/// A stretch of time in which no object is there.
struct IdlePeriod {
    double begin = 0;
    double end = 0;
};

std::vector<IdlePeriod> idle_periods(std::span<const events::Event> events, double begin, double end);

/// What a strip and the picture's other marks are made of.
struct StripStyle {
    image::Rgba ink{};
    image::Rgba pale{};
    image::Rgba lines{};
    image::Rgba background{};
};

/// Draws when each object was there: a bar for each over an even axis of time, thick where it stood; of those that find
/// no row only how many there are.
/// \param begin, end seconds of the clip
/// \param still nothing moved at all
void label_strip(const Objects& objects, double begin, double end, bool still, const labels::Sheet& sheet,
                 const StripStyle& look, labels::Lettering& lettering);

}  // namespace vvr::glance
