#include "core/fields/flows/derivatives.h"

#include <cmath>
#include <functional>

#include "core/kernels/rows.h"

namespace vvr::fields {
namespace {

/// A row with its edge values replicated `border` times on each side.
template <class T>
void widen(std::span<const T> row, int border, std::vector<float>& wide) {
    const auto edge = static_cast<std::size_t>(border);
    wide.resize(row.size() + 2 * edge);
    std::fill_n(wide.begin(), edge, static_cast<float>(row.front()));
    std::ranges::copy(row, wide.begin() + border);
    std::fill_n(wide.end() - border, edge, static_cast<float>(row.back()));
}

template <class T>
Plane<float> smooth_any(const Plane<T>& plane, std::span<const float> taps) {
    const int border = static_cast<int>(taps.size() / 2);
    auto rows = Plane<float>::for_overwrite(plane.size());
    std::vector<float> wide;
    std::vector<const float*> inputs(taps.size());
    for (int j = 0; j < plane.height(); ++j) {
        widen(plane.row(j), border, wide);
        for (std::size_t k = 0; k < taps.size(); ++k) inputs[k] = wide.data() + k;
        kernels::weighted_sum(inputs, taps, rows.row(j).data(), plane.width());
    }
    auto result = Plane<float>::for_overwrite(plane.size());
    for (int j = 0; j < plane.height(); ++j) {
        for (std::size_t k = 0; k < taps.size(); ++k) {
            inputs[k] = rows.row(std::clamp(j + static_cast<int>(k) - border, 0, plane.height() - 1)).data();
        }
        kernels::weighted_sum(inputs, taps, result.row(j).data(), plane.width());
    }
    return result;
}

}  // namespace

std::vector<float> gaussian_taps(double sigma) {
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    std::vector<float> taps;
    for (const double weight : kernels::gaussian_weights(sigma, radius)) taps.push_back(static_cast<float>(weight));
    return taps;
}

std::vector<float> differentiated_taps(std::span<const float> taps) {
    std::vector<float> result(taps.size() + 4, 0.F);
    for (std::size_t i = 0; i < taps.size(); ++i) {
        for (std::size_t k = 0; k < five_point.size(); ++k) result[i + k] += taps[i] * five_point[k];
    }
    return result;
}

Plane<float> smoothed(const Plane<std::uint8_t>& grey, std::span<const float> taps) {
    return smooth_any(grey, taps);
}
Plane<float> smoothed(const Plane<float>& plane, std::span<const float> taps) {
    return smooth_any(plane, taps);
}

void barron_derivatives(std::span<const Plane<float>* const> frames, std::span<const float> taps, const PixelBox& part,
                        PlaneStack& result) {
    const Size frame = frames.front()->size();
    const std::vector<float> change = differentiated_taps(taps);
    result.reset(part.size(), derivative_planes);

    // The frame smoothed along t: the part with two more pixels on each side for the differences along x and y.
    constexpr int border = 2;
    const int left = std::max(part.left - border, 0);
    const int right = std::min(part.left + part.width() + border, frame.width);
    const int width = part.width() + 2 * border;
    Plane<float> smooth({width, part.height() + 2 * border});
    std::vector<const float*> inputs(change.size());
    const auto rows_at = [&](int x, int y) {
        std::ranges::transform(frames, inputs.begin(), [&](const Plane<float>* f) { return f->row(y).data() + x; });
        return std::span<const float* const>(inputs);
    };
    for (int j = 0; j < smooth.height(); ++j) {
        const int y = std::clamp(part.top + j - border, 0, frame.height - 1);
        const int first = left - (part.left - border);
        const int last = first + right - left;
        const std::span<float> out = smooth.row(j);
        kernels::weighted_sum(rows_at(left, y).subspan(2, taps.size()), taps, out.data() + first, right - left);
        std::fill(out.begin(), out.begin() + first, out[static_cast<std::size_t>(first)]);
        std::fill(out.begin() + last, out.end(), out[static_cast<std::size_t>(last) - 1]);
    }

    for (int j = 0; j < part.height(); ++j) {
        const float* const here = smooth.row(j + border).data();
        const std::array<const float*, 5> across{here, here + 1, here + 2, here + 3, here + 4};
        std::array<const float*, 5> down{};
        for (int k = 0; k < 5; ++k) down[static_cast<std::size_t>(k)] = smooth.row(j + k).data() + border;
        kernels::weighted_sum(across, five_point, result.row(along_x, j), part.width());
        kernels::weighted_sum(down, five_point, result.row(along_y, j), part.width());
        kernels::weighted_sum(rows_at(part.left, part.top + j), change, result.row(along_t, j), part.width());
    }
}

void cube_derivatives(const Plane<float>& first, const Plane<float>& second, const PixelBox& part, PlaneStack& result) {
    const Size frame = first.size();
    result.reset(part.size(), derivative_planes);
    for (int j = 0; j < part.height(); ++j) {
        const int y = part.top + j;
        const int below = std::min(y + 1, frame.height - 1);
        for (int i = 0; i < part.width(); ++i) {
            const int x = part.left + i;
            const int next = std::min(x + 1, frame.width - 1);
            const float a = first.at(x, y), b = first.at(next, y), c = first.at(x, below), d = first.at(next, below);
            const float e = second.at(x, y), f = second.at(next, y), g = second.at(x, below),
                        h = second.at(next, below);
            result.row(along_x, j)[i] = (b - a + d - c + f - e + h - g) / 4;
            result.row(along_y, j)[i] = (c - a + d - b + g - e + h - f) / 4;
            result.row(along_t, j)[i] = (e - a + f - b + g - c + h - d) / 4;
        }
    }
}

}  // namespace vvr::fields
