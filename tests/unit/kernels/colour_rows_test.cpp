#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/kernels/rows.h"

namespace vvr {
namespace {

TEST(ColourRows, AreTheStandardsMatrix) {
    // ITU-R BT.601 of limited chroma: every chroma with every tenth luma.
    constexpr double stretch = 255.0 / 224;
    const kernels::ColourMatrix matrix(AVCOL_SPC_SMPTE170M, false);
    std::vector<std::uint8_t> chroma(256);
    for (std::size_t k = 0; k < 256; ++k) chroma[k] = static_cast<std::uint8_t>(k);
    const auto level = [](double value) { return std::clamp(value, 0.0, 255.0); };
    for (int luma = 0; luma < 256; luma += 5) {
        for (int cr = 0; cr < 256; cr += 3) {
            const std::vector<std::uint8_t> y(chroma.size(), static_cast<std::uint8_t>(luma));
            const std::vector<std::uint8_t> v(chroma.size(), static_cast<std::uint8_t>(cr));
            std::vector<Bgr> out(chroma.size() - 1);  // no whole number of vectors
            kernels::to_bgr(matrix, std::span(y).first(out.size()), std::span(chroma).first(out.size()),
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

TEST(FullRange, IsRoundedWhereverAPixelStands) {
    // No whole number of vectors: each level stands in one, and in the rest after them.
    std::vector<std::uint8_t> luma(64 + 7), out(luma.size());
    for (int level = 0; level < 256; ++level) {
        std::ranges::fill(luma, static_cast<std::uint8_t>(level));
        kernels::to_full_range(luma, out);
        const long wanted = std::clamp(std::lround((level - 16) * 255.0 / 219), 0L, 255L);
        EXPECT_TRUE(std::ranges::all_of(out, [&](int value) { return value == wanted; })) << level;
    }
}

}  // namespace
}  // namespace vvr
