#pragma once

#include "core/fields/planes.h"
#include "core/tracking/patch.h"

// What tells an object from the scene itself in another light, or shifted a little.
namespace vvr::tracking {

/// How an object differs from the empty scene at its place.
struct Difference {
    double novelty = 1;  ///< Hellinger distance between the looks of both boxes. A person brings colours of their own.
                         ///< A door, balloons or leaves only move those that are there.
    double texture = 0;  ///< correlation of the gradients: 1 = the scene itself in another light, or mirrored
};

/// \param scene the empty scene, not empty
Difference difference_of(const Patch& patch, const FrameView& sight, const fields::Planes& scene);

}  // namespace vvr::tracking
