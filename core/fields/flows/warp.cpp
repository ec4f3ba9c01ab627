#include "core/fields/flows/warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/fields/flows/weighted_sum.h"

namespace vvr {
namespace {

/// Catmull and Rom's cubic: weights of the four points about a place `t` past the second.
std::array<float, 4> cubic(float t) {
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {0.5F * (2 * t2 - t - t3), 0.5F * (3 * t3 - 5 * t2 + 2), 0.5F * (t + 4 * t2 - 3 * t3), 0.5F * (t3 - t2)};
}

/// Whether there is a picture at this place; `value` is what it shows.
bool sample(const Plane<float>& plane, float x, float y, float& value) {
    const auto right = static_cast<float>(plane.width() - 1);
    const auto bottom = static_cast<float>(plane.height() - 1);
    if (!(x >= 0 && y >= 0 && x <= right && y <= bottom)) return false;
    const int i = static_cast<int>(x);
    const int j = static_cast<int>(y);
    const std::array<float, 4> across = cubic(x - static_cast<float>(i));
    const std::array<float, 4> down = cubic(y - static_cast<float>(j));
    value = 0;
    if (i >= 1 && j >= 1 && i + 2 < plane.width() && j + 2 < plane.height()) {
        for (int k = 0; k < 4; ++k) {
            const float* const row = &plane.at(i - 1, j - 1 + k);
            value += down[static_cast<std::size_t>(k)] *
                     (across[0] * row[0] + across[1] * row[1] + across[2] * row[2] + across[3] * row[3]);
        }
        return true;
    }
    for (int k = 0; k < 4; ++k) {
        const int row = std::clamp(j - 1 + k, 0, plane.height() - 1);
        for (int l = 0; l < 4; ++l) {
            value += down[static_cast<std::size_t>(k)] * across[static_cast<std::size_t>(l)] *
                     plane.at(std::clamp(i - 1 + l, 0, plane.width() - 1), row);
        }
    }
    return true;
}

constexpr std::array five_point{1.F / 12, -8.F / 12, 0.F, 8.F / 12, -1.F / 12};

// A row and a column of `plane` about a point, edges repeated.
void differentiate(const Plane<float>& plane, PlaneStack& result) {
    constexpr int border = 2;
    const int width = plane.width();
    std::vector<float> wide(static_cast<std::size_t>(width + 2 * border));
    for (int j = 0; j < plane.height(); ++j) {
        const std::span<const float> row = plane.row(j);
        std::fill_n(wide.begin(), border, row.front());
        std::ranges::copy(row, wide.begin() + border);
        std::fill_n(wide.end() - border, border, row.back());
        const std::array<const float*, 5> across{&wide[0], &wide[1], &wide[2], &wide[3], &wide[4]};
        weighted_sum(across, five_point, result.row(along_x, j), width);
        std::array<const float*, 5> down{};
        for (int k = 0; k < 5; ++k) {
            down[static_cast<std::size_t>(k)] = plane.row(std::clamp(j + k - border, 0, plane.height() - 1)).data();
        }
        weighted_sum(down, five_point, result.row(along_y, j), width);
    }
}

}  // namespace

PlaneStack warped_derivatives(const Plane<float>& here, const Plane<float>& next, const Flow& flow, const Rect& part) {
    PlaneStack result(here.size(), derivative_planes);
    // The mean of both frames has the derivatives midway between them, which errs least.
    Plane<float> mean(here.size());
    Plane<float> change(here.size());
    std::vector<char> outside(here.pixels().size());
    for (int j = 0; j < here.height(); ++j) {
        for (int i = 0; i < here.width(); ++i) {
            const float a = here.at(i, j);
            float b = a;
            const bool inside = sample(next, static_cast<float>(part.x + i) + flow.u.at(i, j),
                                       static_cast<float>(part.y + j) + flow.v.at(i, j), b);
            outside[static_cast<std::size_t>(j * here.width() + i)] = inside ? 0 : 1;
            mean.at(i, j) = (a + b) / 2;
            change.at(i, j) = b - a;
        }
    }
    differentiate(mean, result);
    for (int j = 0; j < here.height(); ++j) {
        float* const gx = result.row(along_x, j);
        float* const gy = result.row(along_y, j);
        float* const gt = result.row(along_t, j);
        for (int i = 0; i < here.width(); ++i) {
            const bool unknown = outside[static_cast<std::size_t>(j * here.width() + i)] != 0;
            gx[i] = unknown ? 0 : gx[i];
            gy[i] = unknown ? 0 : gy[i];
            gt[i] = unknown ? 0 : change.at(i, j) - gx[i] * flow.u.at(i, j) - gy[i] * flow.v.at(i, j);
        }
    }
    return result;
}

}  // namespace vvr
