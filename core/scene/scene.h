#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/base/wall_clock.h"
#include "core/scene/flow_geometry.h"
#include "core/scene/slices.h"
#include "core/scene/theme.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/volume/cells.h"
#include "core/volume/owners.h"
#include "core/volume/volume.h"

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
FloorShadow floor_shadow(const volume::Volume& volume, const glm::vec4& colour);

/// The shadow of a volume with owners, tinted by the objects' colours, so that a shadow can be matched to its object.
FloorShadow floor_shadow(const volume::Volume& volume, const Theme& theme, const volume::VoxelStyleLookup& identify);

/// The border of the volume's cross-section at time `t`, a t_C.
std::vector<LineSegment> cross_section(const space::Layout& layout, double t, const glm::vec4& colour);

/// The edges of the volume.
std::vector<LineSegment> volume_outline(const space::Layout& layout, const glm::vec4& colour);

/// Maps frames of a volume to frames and times of the clip.
class TimeTable {
  public:
    explicit TimeTable(const volume::Volume& volume);

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

/// An axis-aligned bounding box in P-space.
struct BoundingBox {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool empty() const { return !(low.x <= high.x); }
    void add(const glm::dvec3& point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

/// The bounding box of the whole layout: Fig. 5's box of P-space.
BoundingBox layout_bounds(const space::Layout& layout);

/// The bounding box of the visible cells: Fig. 5's box of the actually rendered volume.
BoundingBox visible_bounds(std::span<const volume::PlacedCells> bricks, const space::Layout& layout,
                           const TransferFunction& transfer);

std::vector<glm::dvec3> corners(const BoundingBox& box);

/// The twelve edges of a box; none if it is empty.
std::vector<LineSegment> box_edges(const BoundingBox& box, const glm::vec4& colour);

/// Outlines of the slices of `stack` within `box`: Fig. 5's slice planes.
/// \param shown approximate number of outlines; only every n-th slice gets one
std::vector<LineSegment> slice_outlines(const BoundingBox& box, const space::Camera& camera, const SliceStack& stack,
                                        int shown, const glm::vec4& colour);

}  // namespace vvr::scene
