#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"
#include "core/volume/cells.h"

namespace vvr::scene {

/// View-aligned slicing planes, with the same spacing for all bricks.
struct SliceStack {
    double nearest = 0;  ///< distance of slice 0 from the eye along the view direction, P-space units
    double spacing = 1;  ///< P-space units between slices
    int count = 0;
};

/// A vertex of a slice polygon.
struct SliceVertex {
    glm::vec3 p;        ///< P-space
    float t_reference;  ///< t_C at the cell's centre: the inverse map is a short series around it
};

/// Triangulated slice polygons, back to front.
struct SliceMesh {
    std::vector<SliceVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::size_t> slice_ends;  ///< end of each non-empty slice in `indices`
};

/// Slices through the whole volume, perpendicular to the view direction.
/// \param count number of slices; 0 = as many as `spacing` requires
/// \param spacing P-space units between slices, if `count` is 0
SliceStack stack_slices(const space::Camera& camera, const space::Layout& layout, int count, double spacing);

/// Intersects the slices with the visible cells of brick `number` that lie in the picture: one polygon per slice and
/// cell, back to front. Adjacent polygons share the vertices on their common side, across bricks too, so that each
/// pixel belongs to exactly one of them.
SliceMesh cut_slices(std::span<const volume::PlacedCells> bricks, std::size_t number, const space::Layout& layout,
                     const TransferFunction& transfer, const space::Camera& camera, const SliceStack& stack);

/// Points in P-space whose convex hull contains the volume: what a camera must show.
std::vector<glm::dvec3> outline_points(const space::Layout& layout);

}  // namespace vvr::scene
