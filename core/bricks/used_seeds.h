#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/bricks/brick.h"
#include "core/bricks/volume.h"
#include "core/fields/seed_flags.h"

namespace vvr::bricks {

/// The brick-based seed filter of §6: of a volume's seeds those of which their bricks make geometry.
/// \param bricks of the volume, in the order of time
/// \param first number of the first of them, counted from the clip's first
/// \param flags instead of the seeds' own
std::vector<FrameSeed> used_seeds(const Volume& volume, std::span<const Brick> bricks, std::int64_t first,
                                  const std::optional<fields::SeedFlags>& flags);

}  // namespace vvr::bricks
