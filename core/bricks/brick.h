#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace vvr::bricks {

/// m consecutive layers of the volume as one 3D texture; §6's logical brick, two integers.
struct Brick {
    std::int64_t first = 0;
    std::int64_t count = 0;

    friend bool operator==(const Brick&, const Brick&) = default;
};

/// Cuts `layers` layers into `bricks` bricks whose lengths differ by at most one; fewer when there aren't as many
/// layers.
std::vector<Brick> cut_into(std::int64_t layers, int bricks);

/// Cuts `layers` layers into bricks of `length`; the last one may be shorter.
std::vector<Brick> cut_by(std::int64_t layers, std::int64_t length);

/// The most layers of a piece.
inline constexpr std::int64_t sub_brick_layers = 32;

/// Cuts bricks into pieces, which are drawn as bricks of their own: emptier, and small enough to stay in the caches.
/// Those of one brick differ by at most one layer.
std::vector<Brick> cut_into_sub_bricks(std::span<const Brick> bricks);

/// Cuts bricks where certain layers begin, ascending.
std::vector<Brick> cut_at(std::span<const Brick> bricks, std::span<const std::int64_t> layers);

}  // namespace vvr::bricks
