#include "core/fields/shadows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace vvr {
namespace {

// A shadow leaves at least this share of the light, for the sky still shines there. Dark clothes leave less.
constexpr float darkest = 0.5F;

// By how much the channels' shares may differ: the sky's light is bluer than the sun's.
constexpr float most_tint = 0.08F;

/// 1 / (level + 1), for a division takes as long as all the rest.
constexpr std::array<float, 256> inverses() {
    std::array<float, 256> table{};
    for (std::size_t level = 0; level < table.size(); ++level) table[level] = 1 / (static_cast<float>(level) + 1);
    return table;
}

bool is_shadow(const Bgr& frame, const Bgr& empty) {
    static constexpr std::array<float, 256> inverse = inverses();
    float least = 10;
    float most = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        const float share = (frame[c] + 1.F) * inverse[empty[c]];
        least = std::min(least, share);
        most = std::max(most, share);
    }
    return least > darkest && most < 1 && most - least < most_tint;
}

struct Point {
    int i, j;
};

/// The points that are not 0; most are, so eight of a row are looked at at a time.
std::vector<Point> points_of(const Plane<std::uint8_t>& object) {
    std::vector<Point> points;
    for (int j = 0; j < object.height(); ++j) {
        const std::uint8_t* const row = object.row(j).data();
        const auto look_at = [&](int begin, int end) {
            for (int i = begin; i < end; ++i) {
                if (row[i] != 0) points.push_back({i, j});
            }
        };
        const int whole = object.width() / 8 * 8;
        for (int i = 0; i < whole; i += 8) {
            std::uint64_t eight = 0;
            std::memcpy(&eight, row + i, sizeof eight);
            if (eight != 0) look_at(i, i + 8);
        }
        look_at(whole, object.width());
    }
    return points;
}

}  // namespace

void remove_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty) {
    if (frame.colour.empty() || empty.colour.empty()) return;
    const std::vector<Point> points = points_of(object);
    if (points.empty()) return;
    // The votes of the box around the points and one pixel more on each side, where nobody votes. Points come by rows.
    const auto [left, right] = std::ranges::minmax(points, {}, &Point::i);
    const int i0 = left.i - 1;
    const int j0 = points.front().j - 1;
    Plane<std::int8_t> votes({right.i - left.i + 3, points.back().j - points.front().j + 3});
    for (const auto& [i, j] : points) {
        votes.at(i - i0, j - j0) = is_shadow(frame.colour.at(i, j), empty.colour.at(i, j)) ? 1 : -1;
    }
    // One pixel proves nothing: most of those about it must look like a shadow too.
    for (const auto& [i, j] : points) {
        int sum = 0;
        for (int y = j - j0 - 1; y <= j - j0 + 1; ++y) {
            for (int x = i - i0 - 1; x <= i - i0 + 1; ++x) sum += votes.at(x, y);
        }
        if (sum > 0) object.at(i, j) = 0;
    }
}

}  // namespace vvr
