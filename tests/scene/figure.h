#pragma once

#include <cstdint>

#include "tests/scene/canvas.h"

namespace vvr::generator {

/// A person seen from the side.
struct Figure {
    Point feet;          ///< on the floor, between the feet
    double height = 80;  ///< pixels
    double stride = 0;   ///< radians; a full turn is two steps
    double facing = 1;   ///< 1 = to the right, -1 = to the left
    double gait = 1;     ///< how far the limbs swing: 1 walking, 0 standing
    double bow = 0;      ///< 0 upright, 1 bent down to the floor
    double fall = 0;     ///< radians that the whole body is tipped forwards about the feet
    std::uint64_t seed = 1;
};

/// The middle of the body, half-way up.
Point middle_of(const Figure& figure);

/// Where the hand in front is, to hold a bag in.
Point hand_of(const Figure& figure);

void paint_shadow(Canvas& canvas, Point feet, double width);
void paint_figure(Canvas& canvas, const Figure& figure);

/// A bag that hangs from, or stands below, a handle.
///
/// \param height of the person it belongs to
void paint_bag(Canvas& canvas, Point handle, double height);

/// The middle of a bag with this handle.
Point middle_of_bag(Point handle, double height);

}  // namespace vvr::generator
