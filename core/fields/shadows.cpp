#include "core/fields/shadows.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

#include "core/base/setting.h"
#include "core/fields/options.h"
#include "core/fields/thresholds.h"

namespace vvr::fields {
namespace {

/// 1 / (level + 1), as a table: a division takes as long as all the rest.
constexpr std::array<float, 256> inverses() {
    std::array<float, 256> table{};
    for (std::size_t level = 0; level < table.size(); ++level) table[level] = 1 / (static_cast<float>(level) + 1);
    return table;
}

/// The smallest and the largest ratio of the channels to the empty scene.
struct Shares {
    float least = 10;
    float most = 0;
};

Shares shares_of(const Bgr& frame, const Bgr& empty) {
    static constexpr std::array<float, 256> inverse = inverses();
    Shares shares;
    for (std::size_t c = 0; c < 3; ++c) {
        const float share = (frame[c] + 1.F) * inverse[empty[c]];
        shares.least = std::min(shares.least, share);
        shares.most = std::max(shares.most, share);
    }
    return shares;
}

bool is_darker(const Shares& shares) {
    return shares.least > thresholds.shadow.darkest && shares.most < 1;
}

/// Sums of the channels over a square of 5 × 5 pixels, of which every second row and column counts. Clipped at the
/// picture's edges.
std::array<int, 3> box_sums(const Plane<Bgr>& picture, int i, int j) {
    constexpr int radius = 2;
    std::array<int, 3> sums{};
    for (int y = std::max(j - radius, 0); y <= std::min(j + radius, picture.height() - 1); y += 2) {
        const Bgr* const row = picture.row(y).data();
        for (int x = std::max(i - radius, 0); x <= std::min(i + radius, picture.width() - 1); x += 2) {
            for (std::size_t c = 0; c < 3; ++c) sums[c] += row[x][c];
        }
    }
    return sums;
}

/// Whether the pixels around it have kept their colour. Compression leaves too little colour in a single pixel.
bool has_kept_colour(const Planes& frame, const Planes& empty, int i, int j) {
    constexpr float one = 9;  // one more level per pixel avoids a ratio of 0
    const std::array<int, 3> now = box_sums(frame.colour, i, j);
    const std::array<int, 3> before = box_sums(empty.colour, i, j);
    std::array<float, 3> shares{};
    for (std::size_t c = 0; c < 3; ++c) {
        shares[c] = (static_cast<float>(now[c]) + one) / (static_cast<float>(before[c]) + one);
    }
    const auto [least, most] = std::ranges::minmax(shares);
    const bool bluer = shares[0] >= shares[2];
    const float tint = thresholds.shadow.tint + (bluer ? thresholds.shadow.sky * std::max(1 - most, 0.F) : 0.F);
    return most - least < tint;
}

constexpr std::array shadow_rows{
    ShadowRow{"remove", "remove areas that are darker but keep their colour", true},
    ShadowRow{"keep", "shadows count as objects", false},
};

struct Point {
    int i, j;
};

/// The points of pixels other than 0. Most pixels are 0, so eight of a row are tested at a time.
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

std::span<const ShadowRow> shadow_kinds() {
    return shadow_rows;
}

std::vector<ShadowPixel> extract_shadows(Plane<std::uint8_t>& object, const Planes& frame, const Planes& empty,
                                         std::uint8_t faint) {
    const std::vector<Point> points = points_of(object);
    if (points.empty()) return {};
    if (!has_colours(frame.colour) || !has_colours(empty.colour)) return {};
    // The votes in the points' bounding box, with a margin of one pixel without votes. Points are ordered by rows.
    const auto [left, right] = std::ranges::minmax(points, {}, &Point::i);
    const int i0 = left.i - 1;
    const int j0 = points.front().j - 1;
    Plane<std::int8_t> votes({right.i - left.i + 3, points.back().j - points.front().j + 3});
    for (const auto& [i, j] : points) {
        const Shares shares = shares_of(frame.colour.at(i, j), empty.colour.at(i, j));
        // Next to its object, a shadow has that object's colour around it.
        const float own_tint = object.at(i, j) < faint ? thresholds.shadow.tint : thresholds.shadow.tint_of_pixel;
        const float tint = shares.most - shares.least;
        const bool may_be = is_darker(shares) && tint < thresholds.shadow.most_tint;
        const bool shadow = may_be && (tint < own_tint || has_kept_colour(frame, empty, i, j));
        votes.at(i - i0, j - j0) = shadow ? 1 : -1;
    }
    std::vector<ShadowPixel> removed;
    // A single pixel is unreliable, so most of its neighbours must look like shadow too.
    for (const auto& [i, j] : points) {
        int sum = 0;
        for (int y = j - j0 - 1; y <= j - j0 + 1; ++y) {
            for (int x = i - i0 - 1; x <= i - i0 + 1; ++x) sum += votes.at(x, y);
        }
        // At an object's edge, half of the neighbours belong to the object: there the pixel itself decides.
        const bool is_taken = sum > 0 || (sum == 0 && votes.at(i - i0, j - j0) > 0);
        if (is_taken) removed.push_back({i, j, std::exchange(object.at(i, j), std::uint8_t{0})});
    }
    return removed;
}

void restore_enclosed(Plane<std::uint8_t>& object, std::span<const ShadowPixel> shadow, int reach, std::uint8_t faint) {
    const std::ptrdiff_t width = object.width();
    /// Whether one of the next `most` pixels belongs to an object.
    const auto is_object_within = [&](const std::uint8_t* from, std::ptrdiff_t step, int most) {
        for (int k = 1; k <= std::min(most, reach); ++k) {
            if (from[k * step] != 0) return true;
        }
        return false;
    };
    std::vector<ShadowPixel> enclosed;
    for (const ShadowPixel& p : shadow) {
        if (p.value < faint) continue;
        const std::uint8_t* const here = &object.at(p.i, p.j);
        if (!is_object_within(here, width, object.height() - 1 - p.j)) continue;
        int missing = is_object_within(here, -1, p.i) ? 0 : 1;
        missing += is_object_within(here, 1, object.width() - 1 - p.i) ? 0 : 1;
        if (missing == 1) missing += is_object_within(here, -width, p.j) ? 0 : 1;
        if (missing < 2) enclosed.push_back(p);
    }
    for (const ShadowPixel& p : enclosed) object.at(p.i, p.j) = p.value;
}

const ShadowRow& row_of(Name<ShadowRow> name) {
    return choose("shadows", name.text, shadow_kinds());
}

}  // namespace vvr::fields
