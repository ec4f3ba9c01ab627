#include "core/fields/changes.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <vector>

namespace vvr {
namespace {

constexpr int tile = 8;

// Mean differences of a tile, in grey levels. In no noise at all, what moves by a tenth of a pixel shows; in the worst
// that a camera may have, a person still does.
constexpr float least = 0.5F;
constexpr float most = 4;

// A tile's mean over that of a quiet tile: noise alone reaches less than this in 64 pixels.
constexpr float above_noise = 1.6F;

/// The mean difference in each tile.
Plane<float> tile_differences(const Plane<std::uint8_t>& before, const Plane<std::uint8_t>& now) {
    const Size size{(now.width() + tile - 1) / tile, (now.height() + tile - 1) / tile};
    Plane<float> result(size);
    for (int y = 0; y < size.height; ++y) {
        const int bottom = std::min((y + 1) * tile, now.height());
        for (int x = 0; x < size.width; ++x) {
            const int right = std::min((x + 1) * tile, now.width());
            int sum = 0;
            for (int j = y * tile; j < bottom; ++j) {
                const std::uint8_t* const a = before.row(j).data();
                const std::uint8_t* const b = now.row(j).data();
                for (int i = x * tile; i < right; ++i) sum += std::abs(a[i] - b[i]);
            }
            result.at(x, y) = static_cast<float>(sum) / static_cast<float>((bottom - y * tile) * (right - x * tile));
        }
    }
    return result;
}

/// What a tile must reach: a quarter of all tiles are quiet in every clip but one whose camera moves, and then the
/// upper bound holds.
float threshold_of(const Plane<float>& differences) {
    std::vector<float> sorted(differences.pixels().begin(), differences.pixels().end());
    const auto quiet = sorted.begin() + std::ssize(sorted) / 4;
    std::ranges::nth_element(sorted, quiet);
    return std::clamp(above_noise * *quiet + 0.25F, least, most);
}

}  // namespace

void mark_changes(const Plane<std::uint8_t>& other, const Plane<std::uint8_t>& here, const Plane<std::uint8_t>& object,
                  Plane<std::uint8_t>& changed) {
    const Plane<float> differences = tile_differences(other, here);
    const float threshold = threshold_of(differences);
    for (int y = 0; y < differences.height(); ++y) {
        for (int x = 0; x < differences.width(); ++x) {
            if (differences.at(x, y) < threshold) continue;
            const int left = std::max((x - 1) * tile, 0);
            const int right = std::min((x + 2) * tile, object.width());
            for (int j = std::max((y - 1) * tile, 0); j < std::min((y + 2) * tile, object.height()); ++j) {
                std::copy(object.row(j).begin() + left, object.row(j).begin() + right, changed.row(j).begin() + left);
            }
        }
    }
}

}  // namespace vvr
