#include "core/fields/motion.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <vector>

#include "core/fields/blobs.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

/// The tiles of two frames.
class Tiles {
  public:
    Tiles(const Plane<std::uint8_t>& a, const Plane<std::uint8_t>& b) : a_(a), b_(b) {}

    int columns() const { return (a_.width() + tile_side - 1) / tile_side; }
    int rows() const { return (a_.height() + tile_side - 1) / tile_side; }

    /// The mean difference in a tile.
    float difference(int x, int y) const {
        const int right = std::min((x + 1) * tile_side, a_.width());
        const int bottom = std::min((y + 1) * tile_side, a_.height());
        int sum = 0;
        for (int j = y * tile_side; j < bottom; ++j) {
            const std::uint8_t* const a = a_.row(j).data();
            const std::uint8_t* const b = b_.row(j).data();
            for (int i = x * tile_side; i < right; ++i) sum += std::abs(a[i] - b[i]);
        }
        return static_cast<float>(sum) / static_cast<float>((bottom - y * tile_side) * (right - x * tile_side));
    }

  private:
    const Plane<std::uint8_t>& a_;
    const Plane<std::uint8_t>& b_;
};

/// The threshold of a tile's mean. At least a quarter of all tiles are quiet unless the camera moves; then the upper
/// bound applies. A sample of the tiles is enough.
float threshold_of(const Tiles& tiles) {
    std::vector<float> differences;
    for (int y = 0; y < tiles.rows(); ++y) {
        for (int x = y % 5; x < tiles.columns(); x += 5) differences.push_back(tiles.difference(x, y));
    }
    constexpr auto& motion = thresholds.motion;
    if (differences.empty()) return motion.least;
    const auto quiet = differences.begin() + std::ssize(differences) / 4;
    std::ranges::nth_element(differences, quiet);
    return std::clamp(motion.above_noise * *quiet + motion.excess, motion.least, motion.most);
}

/// A tile and its neighbours, clipped at the picture's edges.
struct Block {
    int left, right, top, bottom;

    Block(int x, int y, Size size)
        : left(std::max((x - 1) * tile_side, 0)),
          right(std::min((x + 2) * tile_side, size.width)),
          top(std::max((y - 1) * tile_side, 0)),
          bottom(std::min((y + 2) * tile_side, size.height)) {}
};

/// 1 for each tile that is occupied or next to an occupied one.
Plane<std::uint8_t> neighbourhood(const Plane<std::uint8_t>& tiles) {
    Plane<std::uint8_t> result(tiles.size());
    for (int y = 0; y < tiles.height(); ++y) {
        for (int x = 0; x < tiles.width(); ++x) {
            if (tiles.at(x, y) == 0) continue;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, tiles.height() - 1); ++v) {
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, tiles.width() - 1); ++u) result.at(u, v) = 1;
            }
        }
    }
    return result;
}

}  // namespace

void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed) {
    const Plane<std::uint8_t> near_object = neighbourhood(occupied_tiles(object));
    if (std::ranges::none_of(near_object.pixels(), [](int near) { return near == 1; })) return;
    const Tiles tiles(other, here);
    const float threshold = threshold_of(tiles);
    for (int y = 0; y < tiles.rows(); ++y) {
        for (int x = 0; x < tiles.columns(); ++x) {
            if (near_object.at(x, y) == 0 || tiles.difference(x, y) < threshold) continue;
            const Block block(x, y, object.size());
            for (int j = block.top; j < block.bottom; ++j) {
                std::copy(object.row(j).begin() + block.left, object.row(j).begin() + block.right,
                          changed.row(j).begin() + block.left);
            }
        }
    }
}

}  // namespace vvr::fields
