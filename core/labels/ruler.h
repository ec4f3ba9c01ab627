#pragma once

#include <string>
#include <vector>

#include "core/bricks/volume.h"
#include "core/labels/lettering.h"
#include "core/labels/sheet.h"
#include "core/labels/time_ticks.h"
#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::labels {

/// One of the four edges of a volume that run along time: x_C and y_C are 0 or 1 on it.
struct TimeEdge {
    double x = 1;
    double y = 1;
};

/// The edge that lies outermost in a camera's picture, so that labels beside it hide nothing.
TimeEdge outer_edge(const space::Layout& layout, const space::Camera& camera, Size picture);

/// Where marks of a ruler along `edge` end, in P-space: what a camera has to show besides the volume.
std::vector<glm::dvec3> ruler_reach(const space::Layout& layout, const TimeEdge& edge);

/// The marks of the ticks in P-space.
std::vector<scene::LineSegment> ruler_marks(const bricks::Volume& volume, const space::Layout& layout,
                                            const TimeEdge& edge, const std::vector<TimeTick>& ticks,
                                            const glm::vec4& colour);

/// A stretch of the volume in which no frame came.
struct TimeGap {
    double t_begin = 0;  ///< t_C
    double t_end = 0;
    double begin = 0;  ///< seconds
    double end = 0;
    std::string words = "no signal";  ///< why
};

std::vector<TimeGap> time_gaps(const bricks::Volume& volume);

/// Hatching along the edge where frames are missing, in P-space.
std::vector<scene::LineSegment> gap_marks(const std::vector<TimeGap>& gaps, const space::Layout& layout,
                                          const TimeEdge& edge, const glm::vec4& colour);

/// Writes beside the hatching what it means, where there is room.
void label_gaps(const std::vector<TimeGap>& gaps, const space::Layout& layout, const TimeEdge& edge,
                const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering);

/// Ticks for a volume whose layers are of unequal length: `most` at most, about evenly spread over the arc, the
/// roundest moments first.
std::vector<TimeTick> spread_ticks(const bricks::Volume& volume, int most, const WallClock& clock);

/// Where time is squeezed.
struct TimeBreak {
    double t = 0;  ///< t_C
    double seconds = 0;
};

/// The longest of them, at most `most`, in order.
std::vector<TimeBreak> time_breaks(const bricks::Volume& volume, std::size_t most);

/// Two short strokes across the edge for each, as breaks of an axis are drawn.
std::vector<scene::LineSegment> break_marks(const std::vector<TimeBreak>& breaks, const space::Layout& layout,
                                            const TimeEdge& edge, const glm::vec4& colour);

/// Writes beside breaks how long they are, the longest first, where there is room.
void label_breaks(const std::vector<TimeBreak>& breaks, const space::Layout& layout, const TimeEdge& edge,
                  const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering);

/// Writes the ticks beside their marks; those that would touch another or leave the sheet are left out, first those
/// between the first and the last.
void label_ruler(const bricks::Volume& volume, const space::Layout& layout, const TimeEdge& edge,
                 const std::vector<TimeTick>& ticks, const space::Camera& camera, const Sheet& sheet,
                 const image::Rgba& colour, Lettering& lettering);

}  // namespace vvr::labels
