#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/bricks/owners.h"
#include "core/bricks/volume.h"
#include "core/scene/flow_geometry.h"
#include "core/scene/theme.h"
#include "core/space/layout.h"

namespace vvr::scene {

/// A straight line in P-space.
struct LineSegment {
    glm::vec3 from;
    glm::vec3 to;
    glm::vec4 colour;  ///< sRGB and opacity
};

/// A frame of the clip, shown in the volume at its time.
struct StandingFrame {
    double t = 0;  ///< t_C
    Plane<Bgr> picture;
    float opacity = 1;
    double frame = 0;  ///< counted from the volume's first
};

/// A shadow on the floor: the motion seen from above. It shows where in the scene a trail runs.
struct FloorShadow {
    Plane<std::uint8_t> darkness;  ///< a frame's columns; one row per layer of time
    double t_end = 1;              ///< t_C at the end of the rows
    glm::vec4 colour{0, 0, 0, 0.3F};
    Plane<Bgr> tint{};  ///< colour per pixel of `darkness`; empty = `colour` everywhere
};

/// The geometry drawn with the volume.
struct Scene {
    std::vector<Glyph> arrows;
    Tracelines tracelines;
    std::vector<LineSegment> lines;
    std::vector<StandingFrame> frames;
    FloorShadow floor;  ///< empty = not drawn
};

/// The shadow of a volume: the maximum value of each frame column.
FloorShadow floor_shadow(const bricks::Volume& volume, const glm::vec4& colour);

/// The shadow of a volume with owners, tinted by the objects' colours, so that a shadow can be matched to its object.
FloorShadow floor_shadow(const bricks::Volume& volume, const Theme& theme, const bricks::Identify& identify);

/// The border of the volume's cross-section at time `t`, a t_C.
std::vector<LineSegment> cross_section(const space::Layout& layout, double t, const glm::vec4& colour);

/// The edges of the volume.
std::vector<LineSegment> volume_outline(const space::Layout& layout, const glm::vec4& colour);

/// Maps frames of a volume to frames and times of the clip.
class TimeTable {
  public:
    explicit TimeTable(const bricks::Volume& volume);

    /// The clip's frame nearest to `frame`, a fractional number counted from the volume's first frame and clamped to
    /// the volume. Times within a layer are interpolated linearly between its first and last frame.
    Moment at(double frame) const;

    /// Frame numbers per layer; for layers of unequal length, equal shares of a layer instead of frames.
    std::int64_t frames_per_layer() const { return step_; }
    bool empty() const { return layers_.empty(); }

  private:
    struct Entry {
        std::int64_t first_frame = 0;
        std::int64_t last_frame = 0;
        std::int64_t frames = 0;
        double begin = 0;  ///< seconds, its first frame
        double end = 0;    ///< seconds, its last frame
    };

    std::int64_t step_;
    bool nonuniform_;
    std::vector<Entry> layers_;
};

}  // namespace vvr::scene
