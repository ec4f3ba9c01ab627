#include "core/bricks/brick.h"

#include <algorithm>

namespace vvr::bricks {

std::vector<Brick> cut_into(std::int64_t layers, int bricks) {
    const std::int64_t k = std::clamp<std::int64_t>(bricks, 1, std::max<std::int64_t>(layers, 1));
    std::vector<Brick> cut;
    for (std::int64_t j = 0; j < k; ++j) {
        const std::int64_t first = layers * j / k;
        cut.push_back({first, layers * (j + 1) / k - first});
    }
    return cut;
}

std::vector<Brick> cut_by(std::int64_t layers, std::int64_t length) {
    std::vector<Brick> cut;
    for (std::int64_t first = 0; first < layers; first += length) {
        cut.push_back({first, std::min(length, layers - first)});
    }
    return cut;
}

std::vector<Brick> cut_at(std::span<const Brick> bricks, std::span<const std::int64_t> layers) {
    std::vector<Brick> cut;
    for (Brick rest : bricks) {
        for (const std::int64_t layer : layers) {
            if (layer <= rest.first || layer >= rest.first + rest.count) continue;
            cut.push_back({rest.first, layer - rest.first});
            rest = {layer, rest.count - cut.back().count};
        }
        cut.push_back(rest);
    }
    return cut;
}

std::vector<Brick> cut_into_sub_bricks(std::span<const Brick> bricks) {
    std::vector<Brick> pieces;
    for (const Brick& brick : bricks) {
        const std::int64_t count = (brick.count + sub_brick_layers - 1) / sub_brick_layers;
        for (const Brick& piece : cut_into(brick.count, static_cast<int>(count))) {
            pieces.push_back({brick.first + piece.first, piece.count});
        }
    }
    return pieces;
}

}  // namespace vvr::bricks
