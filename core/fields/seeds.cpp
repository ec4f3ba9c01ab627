#include "core/fields/seeds.h"

#include <cmath>

namespace vvr {

std::vector<Seed> make_seeds(const Flow& flow, const Plane<std::uint8_t>& object, const SeedOptions& options) {
    std::vector<Seed> seeds;
    for (int j = options.grid / 2; j < object.height(); j += options.grid) {
        for (int i = options.grid / 2; i < object.width(); i += options.grid) {
            const float u = flow.u.at(i, j);
            const float v = flow.v.at(i, j);
            if (object.at(i, j) == 0 || std::hypot(u, v) < options.min_magnitude) continue;
            seeds.push_back({static_cast<float>(i), static_cast<float>(j), u, v});
        }
    }
    return seeds;
}

}  // namespace vvr
