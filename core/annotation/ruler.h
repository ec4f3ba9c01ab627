#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/annotation/lettering.h"
#include "core/annotation/sheet.h"
#include "core/annotation/time_ticks.h"
#include "core/scene/scene.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/volume/volume.h"

namespace vvr::annotation {

/// One of the volume's four edges along time, on which x_C and y_C are 0 or 1.
struct TimeEdge {
    double x = 1;
    double y = 1;
};

/// The outermost edge in the picture, where labels occlude nothing.
TimeEdge outer_edge(const space::Layout& layout, const space::Camera& camera, Size picture);

/// Outer ends of the ruler's marks along `edge`, in P-space; the camera must show them besides the volume.
std::vector<glm::dvec3> ruler_reach(const space::Layout& layout, const TimeEdge& edge);

/// A mark of the ruler in a picture: its outer end in pixels, and the direction away from the volume.
struct MarkInPicture {
    glm::dvec2 end{};
    glm::dvec2 out{};
};

/// The mark at `t`, t_C.
MarkInPicture mark_in_picture(const space::Layout& layout, const TimeEdge& edge, double t, const space::Camera& camera,
                              Size picture);

/// The ruler's tick marks, in P-space.
std::vector<scene::LineSegment> ruler_marks(const volume::Volume& volume, const space::Layout& layout,
                                            const TimeEdge& edge, const std::vector<TimeTick>& ticks,
                                            const glm::vec4& colour);

/// An interval without frames.
struct TimeGap {
    double t_begin = 0;  ///< t_C
    double t_end = 0;
    double begin = 0;  ///< seconds of the clip
    double end = 0;
    std::string reason = "no signal";
};

std::vector<TimeGap> time_gaps(const volume::Volume& volume);

/// Hatching along the edge over the gaps, in P-space.
std::vector<scene::LineSegment> gap_marks(const std::vector<TimeGap>& gaps, const space::Layout& layout,
                                          const TimeEdge& edge, const glm::vec4& colour);

/// Writes the reasons beside the hatching, where they fit.
void label_gaps(const std::vector<TimeGap>& gaps, const space::Layout& layout, const TimeEdge& edge,
                const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering);

/// Ticks for a volume with layers of unequal length: at most `most`, spread about evenly over the arc, preferring the
/// roundest times.
std::vector<TimeTick> spread_ticks(const volume::Volume& volume, int most, const WallClock& clock);

/// An idle period that is compressed on the time axis.
struct TimeBreak {
    double t = 0;        ///< t_C
    double seconds = 0;  ///< length of the period
};

/// The `most` longest compressed periods, in time order.
std::vector<TimeBreak> time_breaks(const volume::Volume& volume, std::size_t most);

/// Axis break symbols: two short strokes across the edge per break, in P-space.
std::vector<scene::LineSegment> break_marks(const std::vector<TimeBreak>& breaks, const space::Layout& layout,
                                            const TimeEdge& edge, const glm::vec4& colour);

/// Writes the lengths of the breaks beside them, the longest first, where they fit.
void label_breaks(const std::vector<TimeBreak>& breaks, const space::Layout& layout, const TimeEdge& edge,
                  const space::Camera& camera, const Sheet& sheet, const image::Rgba& colour, Lettering& lettering);

/// Writes the ticks' texts beside their marks; leaves out texts that would overlap or leave the sheet.
void label_ticks(const volume::Volume& volume, const space::Layout& layout, const TimeEdge& edge,
                 std::span<const TimeTick> ticks, const space::Camera& camera, const Sheet& sheet,
                 const image::Rgba& colour, Lettering& lettering);

/// Whether the same time has visibly more room in some places than in others.
bool is_uneven(const volume::Volume& volume);

}  // namespace vvr::annotation
