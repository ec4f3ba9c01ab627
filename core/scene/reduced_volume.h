#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "core/base/plane.h"
#include "core/scene/transfer_function.h"
#include "core/volume/owners.h"
#include "core/volume/volume.h"

namespace vvr::scene {

/// Values of a reduced volume: 0 is invisible, the others are spread over the visible values, closer where these are
/// small.
inline constexpr int reduced_levels = 16;

/// How many voxels of a volume one of its reduced volume stands for.
struct Block {
    int side = 1;            ///< along x_C and y_C
    std::int64_t depth = 1;  ///< layers
};

/// A volume at reduced size, for where the whole one has no room. A voxel has the mean extinction of its block, and the
/// object that contributes most to it.
struct ReducedVolume {
    Size size{};              ///< voxels along x_C and y_C
    std::int64_t layers = 0;  ///< voxels along time
    Block block{};
    std::array<std::uint8_t, reduced_levels> values{};  ///< the scalar of each level
    std::vector<std::uint8_t> levels;                   ///< x_C varies fastest, then y_C, then time

    /// Of each voxel with a level above 0, in the same order: 4 times its event's number plus its ObjectState; 0 = of
    /// no event.
    std::vector<std::uint16_t> owners;
};

/// \param volume keeps owners
/// \param palette as of object_palette
/// \param identify as of BrickLayers
ReducedVolume reduced(const volume::Volume& volume, const Block& block, const TransferFunction& transfer,
                      std::span<const glm::vec4> palette, const volume::VoxelStyleLookup& identify);

}  // namespace vvr::scene
