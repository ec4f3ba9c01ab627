#pragma once

#include "core/glance/crops.h"
#include "core/glance/objects.h"
#include "core/glance/trails.h"
#include "core/labels/lettering.h"
#include "core/labels/sheet.h"

namespace vvr::glance {

/// Places stills of the most telling objects in the sheet's band of portraits, with number, deed and time above each,
/// and a line to its place on the trail.
/// \returns the places of the events that have one, from left to right
std::vector<std::size_t> label_portraits(const Objects& objects, const Crops& crops, const Trails& trails,
                                          const labels::Sheet& sheet, const image::Rgba& ink, const image::Rgba& pale,
                                          labels::Lettering& lettering);

/// Writes the number of each object on its trail, where it begins: the most telling ones first, where there is room.
void label_numbers(const Objects& objects, const Trails& trails, const labels::Sheet& sheet,
                    labels::Lettering& lettering);

/// Marks where the longest stays begin and end: a tick across the trail, and the time where there is room.
void label_stays(const Objects& objects, const Trails& trails, const labels::Sheet& sheet,
                  const image::Rgba& background, labels::Lettering& lettering);

}  // namespace vvr::glance
