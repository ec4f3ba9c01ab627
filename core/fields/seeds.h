#pragma once

#include <cstdint>
#include <vector>

#include "core/fields/field.h"
#include "core/fields/options.h"

namespace vvr {

/// The seeds of one frame (§4.2): points of a grid where the flow reaches the least magnitude and `object` is not 0.
/// \param object of the flow's size
std::vector<Seed> make_seeds(const Flow& flow, const Plane<std::uint8_t>& object, const SeedOptions& options);

}  // namespace vvr
