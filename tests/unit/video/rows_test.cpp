#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/video/colour_rows.h"
#include "core/video/doubled.h"

namespace vvr {
namespace {

std::vector<std::uint8_t> noise(std::size_t count) {
    std::mt19937 random(5);
    std::vector<std::uint8_t> values(count);
    for (std::uint8_t& value : values) value = static_cast<std::uint8_t>(random());
    return values;
}

/// Linear between the points (i, j) of a plane, the edges repeated.
double linear_at(Size size, const std::vector<std::uint8_t>& plane, double x, double y) {
    const auto at = [&](double i, double j) {
        const auto column = static_cast<std::size_t>(std::clamp(i, 0.0, size.width - 1.0));
        const auto row = static_cast<std::size_t>(std::clamp(j, 0.0, size.height - 1.0));
        return static_cast<double>(plane[row * static_cast<std::size_t>(size.width) + column]);
    };
    const double i = std::floor(x);
    const double j = std::floor(y);
    return std::lerp(std::lerp(at(i, j), at(i + 1, j), x - i), std::lerp(at(i, j + 1), at(i + 1, j + 1), x - i), y - j);
}

TEST(DoublePlane, IsLinearBetweenThePoints) {
    for (const Size size : {Size{1, 1}, Size{3, 2}, Size{33, 5}, Size{64, 4}, Size{71, 3}}) {
        const auto plane = noise(static_cast<std::size_t>(size.width * size.height));
        std::vector<std::uint8_t> twice(4 * plane.size());
        double_plane(size, plane.data(), static_cast<std::size_t>(size.width), twice);
        for (std::size_t k = 0; k < twice.size(); ++k) {
            const auto i = static_cast<double>(k % static_cast<std::size_t>(2 * size.width));
            const auto j = static_cast<double>(k / static_cast<std::size_t>(2 * size.width));
            const double expected = linear_at(size, plane, i / 2 - 0.25, j / 2 - 0.25);
            ASSERT_NEAR(twice[k], expected, 0.501) << size.width << "x" << size.height << " at " << i << ", " << j;
        }
    }
}

TEST(ColourRows, AreTheStandardsMatrix) {
    // ITU-R BT.601 of limited chroma: every chroma with every tenth luma.
    constexpr double stretch = 255.0 / 224;
    const ColourMatrix matrix(AVCOL_SPC_SMPTE170M, false);
    std::vector<std::uint8_t> chroma(256);
    for (std::size_t k = 0; k < 256; ++k) chroma[k] = static_cast<std::uint8_t>(k);
    const auto level = [](double value) { return std::clamp(value, 0.0, 255.0); };
    for (int luma = 0; luma < 256; luma += 5) {
        for (int cr = 0; cr < 256; cr += 3) {
            const std::vector<std::uint8_t> y(chroma.size(), static_cast<std::uint8_t>(luma));
            const std::vector<std::uint8_t> v(chroma.size(), static_cast<std::uint8_t>(cr));
            std::vector<Bgr> out(chroma.size() - 1);  // no whole number of vectors
            to_bgr(matrix, std::span(y).first(out.size()), std::span(chroma).first(out.size()),
                   std::span(v).first(out.size()), out);
            for (std::size_t k = 0; k < out.size(); ++k) {
                const double b = stretch * (static_cast<double>(k) - 128);
                const double r = stretch * (cr - 128);
                ASSERT_NEAR(out[k][0], level(luma + 1.772 * b), 0.53) << luma << " " << k << " " << cr;
                ASSERT_NEAR(out[k][1], level(luma - 0.344136 * b - 0.714136 * r), 0.53);
                ASSERT_NEAR(out[k][2], level(luma + 1.402 * r), 0.53);
            }
        }
    }
}

}  // namespace
}  // namespace vvr
