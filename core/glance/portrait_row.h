#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"

namespace vvr::glance {

/// A place on an object's trail that the line from its portrait may lead to.
struct Anchor {
    glm::dvec2 pixel{};
    double cost = 0;  ///< pixels by which a line to it may be longer than one to a better place
};

/// A portrait that has no place yet.
struct WantedPortrait {
    double seconds = 0;  ///< portraits are in the order of these
    std::vector<Anchor> anchors;
};

/// A portrait in the row, and the line that joins it to the trail.
struct PlacedPortrait {
    std::size_t wanted = 0;  ///< place in the list of those that were wanted
    PixelBox still;
    glm::dvec2 from{};  ///< the line begins at the still's lower edge
    glm::dvec2 to{};
};

/// Places portraits in a row above a picture of trails, in the order of their times, as near to their trails as the
/// others allow. No two lines cross: where two would, the one that was wanted less gives up its place to the next.
/// \param wanted the most wanted first; anchors lie below the row
/// \param row in which the stills are; as high as they are
/// \param gap pixels between two of them
/// \param obstacles that lines lead around where they can
std::vector<PlacedPortrait> place_portraits(std::span<const WantedPortrait> wanted, const PixelBox& row, int gap,
                                            std::span<const PixelBox> obstacles);

/// Whether two straight lines have a point in common.
bool lines_cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d);

}  // namespace vvr::glance
