#pragma once

#include <limits>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/bricks/cells.h"
#include "core/scene/scene.h"
#include "core/scene/slices.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::scene {

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
BoundingBox visible_bounds(std::span<const bricks::PlacedCells> bricks, const space::Layout& layout,
                           const TransferFunction& transfer);

std::vector<glm::dvec3> corners(const BoundingBox& box);

/// The twelve edges of a box; none if it is empty.
std::vector<LineSegment> box_edges(const BoundingBox& box, const glm::vec4& colour);

/// Outlines of the slices of `stack` within `box`: Fig. 5's slice planes.
/// \param shown approximate number of outlines; only every n-th slice gets one
std::vector<LineSegment> slice_outlines(const BoundingBox& box, const space::Camera& camera, const SliceStack& stack,
                                        int shown, const glm::vec4& colour);

}  // namespace vvr::scene
