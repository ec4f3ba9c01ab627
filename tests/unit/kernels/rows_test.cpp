#include "core/kernels/rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace vvr {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// The plain sum over all pixels within `radius`.
double plain_blur(Size size, int channels, const Bytes& from, double sigma, int radius, int i, int j, int channel) {
    double sum = 0;
    double weights = 0;
    for (int y = -radius; y <= radius; ++y) {
        for (int x = -radius; x <= radius; ++x) {
            const double weight = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
            const int column = std::clamp(i + x, 0, size.width - 1);
            const int row = std::clamp(j + y, 0, size.height - 1);
            const int place = (row * size.width + column) * channels + channel;
            sum += weight * from[static_cast<std::size_t>(place)];
            weights += weight;
        }
    }
    return sum / weights;
}

TEST(BlurBytes, IsAGaussian) {
    std::mt19937 random(3);
    for (const int channels : {1, 3}) {
        for (const Size size : {Size{1, 1}, Size{2, 7}, Size{37, 9}, Size{64, 16}}) {
            for (const auto& [sigma, radius] : {std::pair{0.7, 1}, std::pair{1.4, 2}, std::pair{3.0, 5}}) {
                Bytes from(static_cast<std::size_t>(size.width * size.height * channels));
                for (std::uint8_t& value : from) value = static_cast<std::uint8_t>(random());
                Bytes to(from.size());
                kernels::blur_bytes(size, channels, sigma, from, to);
                for (std::size_t k = 0; k < to.size(); ++k) {
                    const int pixel = static_cast<int>(k) / channels;
                    const double expected = plain_blur(size, channels, from, sigma, radius, pixel % size.width,
                                                       pixel / size.width, static_cast<int>(k) % channels);
                    ASSERT_NEAR(to[k], expected, 1.5) << size.width << "x" << size.height << ", sigma " << sigma;
                }
            }
        }
    }
}

TEST(LargestDifference, IsThatOfTheChannelThatDiffersMost) {
    std::mt19937 random(5);
    for (const std::size_t count : {0U, 1U, 31U, 32U, 100U}) {
        std::vector<Bgr> a(count);
        std::vector<Bgr> b(count);
        for (auto* pixels : {&a, &b}) {
            for (Bgr& pixel : *pixels)
                std::ranges::generate(pixel, [&] { return static_cast<std::uint8_t>(random()); });
        }
        Bytes found(count);
        kernels::largest_difference(a, b, found);
        for (std::size_t i = 0; i < count; ++i) {
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a[i][c] - b[i][c]));
            EXPECT_EQ(found[i], most);
        }
    }
}

TEST(BlurBytes, LeavesAPlainPictureAsItIs) {
    for (const int level : {0, 1, 127, 254, 255}) {
        const Bytes from(50 * 20, static_cast<std::uint8_t>(level));
        Bytes to(from.size());
        kernels::blur_bytes({50, 20}, 1, 0.7, from, to);
        EXPECT_EQ(from, to);
    }
}

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

TEST(WeightedSum, IsThePlainSumAtEveryLength) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> value(-1, 1);
    std::vector<float> in(120);
    for (float& x : in) x = value(random);
    const std::array weights{0.25F, -1.5F, 3.F};
    const std::array<const float*, 3> inputs{in.data(), in.data() + 1, in.data() + 40};
    for (int count = 1; count < 70; ++count) {
        std::vector<float> out(static_cast<std::size_t>(count) + 1, 99.F);
        kernels::weighted_sum(inputs, weights, out.data(), count);
        for (std::size_t i = 0; i + 1 < out.size(); ++i) {
            const double plain = 0.25 * in[i] - 1.5 * in[i + 1] + 3.0 * in[i + 40];
            ASSERT_NEAR(out[i], plain, 1e-6) << i << " of " << count;
        }
        ASSERT_EQ(out.back(), 99.F) << "written beyond its end";
    }
}

TEST(WeightedSum, DependsOnNoPlaceInTheRow) {
    std::vector<float> in(100);
    for (std::size_t i = 0; i < in.size(); ++i) in[i] = 1.F / static_cast<float>(i + 3);
    const std::array weights{0.1F, 0.7F, 0.2F};
    const std::array<const float*, 3> whole{in.data(), in.data() + 1, in.data() + 2};
    std::vector<float> expected(90);
    kernels::weighted_sum(whole, weights, expected.data(), 90);
    for (std::size_t first = 0; first < 40; ++first) {
        const std::array<const float*, 3> part{in.data() + first, in.data() + first + 1, in.data() + first + 2};
        std::vector<float> out(50);
        kernels::weighted_sum(part, weights, out.data(), 50);
        for (std::size_t i = 0; i < out.size(); ++i) ASSERT_EQ(out[i], expected[first + i]) << first;
    }
}

}  // namespace
}  // namespace vvr
