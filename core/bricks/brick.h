#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vvr::bricks {

/// Consecutive layers of the volume that form one 3D texture: the logical brick of §6.
struct Brick {
    std::int64_t first = 0;
    std::int64_t count = 0;

    friend bool operator==(const Brick&, const Brick&) = default;
};

/// Cuts `layers` layers into `bricks` bricks whose lengths differ by at most one. Makes fewer bricks if there are fewer
/// layers.
std::vector<Brick> cut_into(std::int64_t layers, int bricks);

/// Cuts `layers` layers into bricks of `length`; the last one may be shorter.
std::vector<Brick> cut_by(std::int64_t layers, std::int64_t length);

/// Maximum number of layers of a sub-brick.
inline constexpr std::int64_t sub_brick_layers = 32;

/// Cuts bricks into sub-bricks, which are drawn like bricks. They skip more empty space and fit into the GPU's caches.
/// The lengths of a brick's sub-bricks differ by at most one layer.
std::vector<Brick> cut_into_sub_bricks(std::span<const Brick> bricks);

/// Cuts bricks at the beginning of the given layers.
/// \param layers ascending
std::vector<Brick> cut_at(std::span<const Brick> bricks, std::span<const std::int64_t> layers);

}  // namespace vvr::bricks
