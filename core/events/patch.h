#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/events/event.h"
#include "core/fields/field.h"
#include "core/fields/planes.h"

namespace vvr::events {

/// What is seen at one moment: the field, and the frame of which it was made. The planes are of one size; a frame
/// without colour or without a picture leaves those empty, and then objects are told apart by what is left.
struct FrameView {
    const Plane<std::uint8_t>& field;  ///< 0 = nothing; else part of an object
    const Plane<std::uint8_t>& grey;
    const Plane<Bgr>& colour;

    Bgr at(int i, int j) const {
        if (!colour.empty()) return colour.at(i, j);
        const std::uint8_t value = grey.empty() ? field.at(i, j) : grey.at(i, j);
        return {value, value, value};
    }

    int brightness(int i, int j) const { return fields::brightness_of(at(i, j)); }
};

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

/// How strong the edges of a picture are along the outline of a patch: the mean change of brightness across it, grey
/// levels. A thing has its edges in the frame. A ghost, the place of something that belonged to the empty scene and
/// went, has them in the empty scene; a patch of light has them in neither.
double edge_strength(const Patch& patch, const FrameView& sight);

/// Which pixels of a field belong to which track, as runs of columns; a pixel that no run names belongs to none.
///
/// A track's event is known only when the clip has ended, because tracks are joined then. So the runs are kept, and the
/// numbers looked up in `Event::tracks` afterwards; a number that no event has is that of something that turned out to
/// be none. Runs of a busy frame take about a hundredth of its field.
struct FrameLabels {
    Moment at;
    std::vector<fields::LabelRun> runs;
};

/// Adds the pixels of a patch.
void add_runs(const Patch& patch, std::size_t track, FrameLabels& labels);

/// The place in the list of the event that each track became a part of; none for those of no event. Indexed by track.
std::vector<std::optional<std::size_t>> events_of_tracks(std::span<const Event> events);

}  // namespace vvr::events
