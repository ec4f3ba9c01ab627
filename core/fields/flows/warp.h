#pragma once

#include "core/fields/flow.h"
#include "core/fields/flows/derivatives.h"

namespace vvr::fields {

/// Derivatives of two frames of which the second is moved back by `flow`, such that the linear equations of them have
/// the whole flow as their solution, not only what is missing from it. Where the flow leads out of the picture all
/// are 0: nothing is known there.
///
/// \param here part `part` of the first frame; `flow` is of its size
void warped_derivatives(const Plane<float>& here, const Plane<float>& next, const Flow& flow, const Rect& part,
                        PlaneStack& result);

}  // namespace vvr::fields
