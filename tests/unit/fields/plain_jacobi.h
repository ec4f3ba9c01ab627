#pragma once

#include "core/fields/field.h"

namespace vvr::test {

/// The paper's iteration (§4.1) as it is written there, point by point: what the fast one must agree with, and what it
/// is measured against.
/// \param ix, iy, it derivatives, all of one size
fields::Flow plain_jacobi(const Plane<float>& ix, const Plane<float>& iy, const Plane<float>& it, float alpha,
                          int steps);

}  // namespace vvr::test
