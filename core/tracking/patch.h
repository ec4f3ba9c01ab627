#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/plane.h"
#include "core/fields/field.h"
#include "core/fields/planes.h"
#include "core/tracking/event.h"

namespace vvr::tracking {

/// A field and the frame of which it was made, all of one size. Without colour or picture those planes are empty, and
/// objects are told apart by the rest.
struct FrameView {
    const Plane<std::uint8_t>& field;  ///< 0 = background; else part of an object
    const Plane<std::uint8_t>& grey;
    const Plane<Bgr>& colour;
    std::size_t view = 0;                         ///< as `fields::Field::view`
    bool damaged = false;                         ///< as `media::Frame::damaged`, or in another light
    const fields::NewScene* new_scene = nullptr;  ///< as `fields::Field::scene`

    Bgr at(int i, int j) const {
        if (!colour.empty()) return colour.at(i, j);
        const std::uint8_t value = grey.empty() ? field.at(i, j) : grey.at(i, j);
        return {value, value, value};
    }

    int brightness(int i, int j) const { return fields::brightness_of(at(i, j)); }
};

/// The pixels of one object in one field.
struct Patch {
    PixelBox box;
    Plane<std::uint8_t> values;  ///< of the box; 0 = not of the object
    int area = 0;
    glm::dvec2 centre{};

    /// The value at a pixel of the field; 0 outside of the box.
    std::uint8_t at(int i, int j) const {
        const bool within = i >= box.left && i < box.right && j >= box.top && j < box.bottom;
        return within ? values.at(i - box.left, j - box.top) : std::uint8_t{0};
    }
};

/// Calls `action(i, j, value)` for each pixel of the patch; i and j are column and row of the field.
template <class Action>
void for_each_pixel(const Patch& patch, Action action) {
    for (int j = 0; j < patch.box.height(); ++j) {
        for (int i = 0; i < patch.box.width(); ++i) {
            if (const std::uint8_t value = patch.values.at(i, j)) action(patch.box.left + i, patch.box.top + j, value);
        }
    }
}

/// The pixels of `patch` for which `wanted(i, j)` is true.
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

/// Whether the box is at the border of a field of this size, or within one pixel of it.
bool touches_border(const PixelBox& box, Size field);

/// Whether at least half (`thresholds.most`) of `box` is inside `other`.
bool is_mostly_inside(const PixelBox& box, const PixelBox& other);

/// The objects of one field.
struct Blobs {
    Plane<int> labels;  ///< 1 + index in `patches`, also for pixels within `reach`; 0 = none
    std::vector<Patch> patches;
};

/// The union of both; where they overlap, the larger value.
Patch joined(const Patch& a, const Patch& b);

/// The same pixels at another place.
Patch translated(Patch patch, const glm::ivec2& by);

/// Finds the objects of a field: connected components of its non-zero pixels, after a dilation by `reach`. So pixels at
/// most 2 `reach` + 1 columns or rows apart belong together. Filters often cut a person in two across the body, and two
/// people walk side by side: hence the vertical reach is the longer one.
/// \param min_area field pixels; smaller components are dropped
Blobs find_blobs(const Plane<std::uint8_t>& field, const glm::ivec2& reach, int min_area);

/// The mean contrast of a picture across the outline of a patch, grey levels. A real thing has edges in the frame. A
/// ghost (the place of a removed thing that the empty scene still has) has edges in the empty scene. A patch of light
/// has edges in neither.
double edge_strength(const Patch& patch, const FrameView& sight);

/// The track of each pixel of a field, as runs of columns; pixels without a run belong to none.
///
/// Tracks are joined to events only when the clip has ended. So the runs are kept, and their numbers are looked up in
/// `Event::tracks` afterwards; a number without an event belongs to a dropped track. The runs of a busy frame need
/// about a hundredth of the field's memory.
struct FrameLabels {
    Moment at;
    std::vector<fields::LabelRun> runs;
};

/// Adds the pixels of a patch to the labels.
void add_runs(const Patch& patch, std::size_t track, FrameLabels& labels);

/// The index of each track's event, by the number of the track; nothing for a track without an event.
std::vector<std::optional<std::size_t>> events_of_tracks(std::span<const Event> events);

}  // namespace vvr::tracking
