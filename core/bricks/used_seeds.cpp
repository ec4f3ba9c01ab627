#include "core/bricks/used_seeds.h"

#include <algorithm>

namespace vvr::bricks {

std::vector<FrameSeed> used_seeds(const Volume& volume, std::span<const Brick> bricks, std::int64_t first,
                                  const std::optional<fields::SeedFlags>& flags) {
    std::vector<FrameSeed> used;
    for (const FrameSeed& at : volume.seeds()) {
        const std::int64_t layer = at.frame / volume.step();
        const auto after = std::ranges::upper_bound(bricks, layer, {}, &Brick::first);
        const std::int64_t brick = first + std::max<std::int64_t>(0, after - bricks.begin() - 1);
        if (flags.value_or(at.seed.flags).in(brick)) used.push_back(at);
    }
    return used;
}

}  // namespace vvr::bricks
