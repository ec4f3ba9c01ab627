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

/// A frame of the clip that stands in the volume at its time.
struct StandingFrame {
    double t = 0;  ///< t_C
    Plane<Bgr> picture;
    float opacity = 1;
    double frame = 0;  ///< counted from the volume's first
};

/// What moved, seen from above: it lies under the volume and shows where in the scene a trail runs.
struct FloorShadow {
    Plane<std::uint8_t> darkness;  ///< columns as in a frame, a row for each layer of time
    double t_end = 1;              ///< t_C to which the rows reach
    glm::vec4 colour{0, 0, 0, 0.3F};
    Plane<Bgr> tint{};  ///< of the darkness; empty = `colour` alone
};

/// The geometry that is drawn with the volume.
struct Scene {
    std::vector<Glyph> arrows;
    Tracelines tracelines;
    std::vector<LineSegment> lines;
    std::vector<StandingFrame> frames;
    FloorShadow floor;  ///< empty where none is to be drawn
};

/// The shadow of all that is in a volume: of each column of a frame the strongest value.
FloorShadow floor_shadow(const bricks::Volume& volume, const glm::vec4& colour);

/// The same of a volume that keeps owners: the shadow of an object has something of its colour, so that one can be
/// found from the other.
FloorShadow floor_shadow(const bricks::Volume& volume, const Theme& theme, const bricks::Identify& identify);

/// The border of the volume's cross-section at one time.
std::vector<LineSegment> cross_section(const space::Layout& layout, double t, const glm::vec4& colour);

/// The edges of the volume.
std::vector<LineSegment> volume_outline(const space::Layout& layout, const glm::vec4& colour);

/// Which frame of the clip a frame of a volume is, and when it was.
class TimeTable {
  public:
    explicit TimeTable(const bricks::Volume& volume);

    /// The frame nearest to a (fractional) number counted from the volume's first frame; beyond the ends, theirs.
    /// Between the first and the last frame of a layer times are linear, as only those two are known.
    Moment at(double frame) const;

    /// Numbers per layer; of layers of unequal length these are shares of a layer, not frames.
    std::int64_t frames_per_layer() const { return step_; }
    bool empty() const { return layers_.empty(); }

  private:
    struct Entry {
        std::int64_t first_frame = 0;
        std::int64_t last_frame = 0;
        std::int64_t frames = 0;
        double begin = 0;  ///< seconds, of its first frame
        double end = 0;    ///< of its last
    };

    std::int64_t step_;
    bool nonuniform_;
    std::vector<Entry> layers_;
};

}  // namespace vvr::scene
