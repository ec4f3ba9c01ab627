#pragma once

#include <vector>

#include "core/base/plane.h"
#include "core/events/event.h"

namespace vvr::events {

/// The pixels of one object in one field: their values, and 0 where there are none of it.
struct Patch {
    PixelBox box;
    Plane<std::uint8_t> values;  ///< of the box
    int area = 0;
    glm::dvec2 centre{};

    /// The value at a place of the field, 0 beyond the box.
    std::uint8_t at(int i, int j) const {
        const bool within = i >= box.left && i < box.right && j >= box.top && j < box.bottom;
        return within ? values.at(i - box.left, j - box.top) : std::uint8_t{0};
    }
};

/// Calls `action(i, j, value)` for each pixel of the patch, in the field's columns and rows.
template <class Action>
void for_each_pixel(const Patch& patch, Action action) {
    for (int j = 0; j < patch.box.height(); ++j) {
        for (int i = 0; i < patch.box.width(); ++i) {
            if (const std::uint8_t value = patch.values.at(i, j)) action(patch.box.left + i, patch.box.top + j, value);
        }
    }
}

/// The pixels of `patch` that `wanted(i, j)` keeps.
template <class Wanted>
Patch part_of(const Patch& patch, Wanted wanted) {
    Patch part{.box = patch.box, .values = Plane<std::uint8_t>(patch.values.size())};
    for_each_pixel(patch, [&](int i, int j, std::uint8_t value) {
        if (!wanted(i, j)) return;
        part.values.at(i - patch.box.left, j - patch.box.top) = value;
        part.centre += glm::dvec2(i, j);
        ++part.area;
    });
    if (part.area > 0) part.centre /= part.area;
    return part;
}

/// The objects of one field, and where they are.
struct Blobs {
    Plane<int> labels;  ///< 1 + place in `patches`, and that of the nearest within `reach`; 0 = none
    std::vector<Patch> patches;
};

/// The pixels of both; where they overlap, the larger value.
Patch joined(const Patch& a, const Patch& b);

/// The same pixels at another place.
Patch translated(Patch patch, const glm::ivec2& by);

/// The objects of a field: pixels that are not 0. Those at most 2 `reach` + 1 columns or rows apart belong together,
/// because a filter often cuts a person in two. It does so across the body, and two people walk side by side: so the
/// reach down is the longer one.
/// \param min_area pixels; of fewer, there is no object
Blobs find_blobs(const Plane<std::uint8_t>& field, const glm::ivec2& reach, int min_area);

}  // namespace vvr::events
