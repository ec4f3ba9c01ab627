#include "core/fields/shadows.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace vvr {
namespace {

// A shadow leaves at least this share of the light, for the sky still shines there, and takes this share at least.
constexpr float darkest = 0.4F;
constexpr float brightest = 0.97F;

// By how much the channels' shares may differ: the sky's light is bluer than the sun's.
constexpr float most_tint = 0.12F;

// Half the side of the square in which textures are compared.
constexpr int reach = 2;

// A scene that varies by less than this share from a pixel to those about it is all noise.
constexpr float least_texture = 0.025F;

// Of the scene's variation so much may remain in the share of light.
constexpr float most_left = 0.6F;

/// The share of light that is left at a pixel of the object; 0 where it can't be a shadow.
float share_of(const Planes& frame, const Planes& empty, int i, int j) {
    const float share = (frame.grey.at(i, j) + 1.F) / (empty.grey.at(i, j) + 1.F);
    if (share < darkest || share > brightest) return 0;
    if (frame.colour.empty() || empty.colour.empty()) return share;
    float least = 10, most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const float one = (frame.colour.at(i, j)[c] + 1.F) / (empty.colour.at(i, j)[c] + 1.F);
        least = std::min(least, one);
        most = std::max(most, one);
    }
    return most - least < most_tint && most < 1 ? share : 0;
}

/// Calls `use(x, y)` for each pixel of the square about (i, j) but itself.
template <class Use>
void for_neighbours(Size size, int i, int j, int distance, Use use) {
    for (int y = std::max(j - distance, 0); y <= std::min(j + distance, size.height - 1); ++y) {
        for (int x = std::max(i - distance, 0); x <= std::min(i + distance, size.width - 1); ++x) {
            if (x != i || y != j) use(x, y);
        }
    }
}

// Only with neighbours that may be shadow too, for what casts it stands close by.
bool keeps_texture(const Plane<float>& shares, const Plane<std::uint8_t>& empty, int i, int j) {
    float texture = 0, left = 0;
    int count = 0;
    for_neighbours(shares.size(), i, j, reach, [&](int x, int y) {
        if (shares.at(x, y) == 0) return;
        texture += std::abs(static_cast<float>(empty.at(x, y) - empty.at(i, j))) / (empty.at(i, j) + 1.F);
        left += std::abs(shares.at(x, y) - shares.at(i, j)) / shares.at(i, j);
        ++count;
    });
    return count >= 5 && texture > least_texture * static_cast<float>(count) && left < most_left * texture;
}

}  // namespace

void remove_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty) {
    struct Point {
        int x;
        int y;
    };
    std::vector<Point> candidates;
    Plane<float> shares(object.size());
    for (int j = 0; j < object.height(); ++j) {
        for (int i = 0; i < object.width(); ++i) {
            if (object.at(i, j) == 0) continue;
            shares.at(i, j) = share_of(frame, empty, i, j);
            if (shares.at(i, j) > 0) candidates.push_back({i, j});
        }
    }
    Plane<std::uint8_t> looks_like_one(object.size());
    for (const auto& [i, j] : candidates) looks_like_one.at(i, j) = keeps_texture(shares, empty.grey, i, j) ? 1 : 0;
    // One pixel more or less proves nothing: most of those about it that may be shadow must look like it.
    for (const auto& [i, j] : candidates) {
        int votes = looks_like_one.at(i, j) == 1 ? 1 : -1;
        for_neighbours(object.size(), i, j, 1, [&](int x, int y) {
            if (shares.at(x, y) > 0) votes += looks_like_one.at(x, y) == 1 ? 1 : -1;
        });
        if (votes > 0) object.at(i, j) = 0;
    }
}

}  // namespace vvr
