#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/bricks/cells.h"
#include "core/space/layout.h"

namespace vvr::gl {

/// A brick, or a picture that stands in the volume.
struct DrawnPart {
    bool stands = false;
    std::size_t number = 0;  ///< of the brick or the picture

    friend bool operator==(const DrawnPart&, const DrawnPart&) = default;
};

/// The bricks of a window and the pictures that stand in it, farthest from `from` first: a picture is drawn between its
/// neighbours, so that it hides what is behind it, and is hidden by what is before it.
/// \param bricks in the order of time; may be none
/// \param standing t_C of each picture, in any order; where it lies within a brick it is drawn at the nearer end
std::vector<DrawnPart> drawing_order(const space::Layout& layout, const glm::dvec3& from,
                                     std::span<const bricks::PlacedCells> bricks, std::span<const double> standing);

}  // namespace vvr::gl
