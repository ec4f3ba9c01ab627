#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/bricks/cells.h"
#include "core/scene/transfer_function.h"
#include "core/space/camera.h"
#include "core/space/layout.h"

namespace vvr::scene {

/// The planes perpendicular to the view direction that cut the volume, one spacing for all bricks.
struct SliceStack {
    double nearest = 0;  ///< distance of slice 0 from the eye along the view direction
    double spacing = 1;  ///< P-space units between slices
    int count = 0;
};

/// A corner of a piece of slice.
struct SliceVertex {
    glm::vec3 p;        ///< P-space
    float t_reference;  ///< t_C of the middle of its cell: near it the inverse of the map is a short series
};

/// Triangles of slices cut out of cells, back to front.
struct SliceMesh {
    std::vector<SliceVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::size_t> slice_ends;  ///< in the indices, of each slice that has triangles
};

/// `count` slices through the volume, perpendicular to the view direction of `camera`; 0 = slices `spacing` P-space
/// units apart.
SliceStack stack_slices(const space::Camera& camera, const space::Layout& layout, int count, double spacing);

/// Where the slices meet those cells of brick `number` of `bricks` that hold something visible and lie in the picture:
/// plane ∩ cell polygons, farthest first. Polygons that meet have the corners on their common side in common, across
/// bricks too, so that each pixel belongs to one of them.
SliceMesh cut_slices(std::span<const bricks::PlacedCells> bricks, std::size_t number, const space::Layout& layout,
                     const TransferFunction& transfer, const space::Camera& camera, const SliceStack& stack);

/// Points of P-space whose hull holds the whole volume: what a camera has to show.
std::vector<glm::dvec3> outline_points(const space::Layout& layout);

}  // namespace vvr::scene
