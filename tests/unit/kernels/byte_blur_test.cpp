#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/kernels/rows.h"

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

TEST(BlurBytes, LeavesAPlainPictureAsItIs) {
    for (const int level : {0, 1, 127, 254, 255}) {
        const Bytes from(50 * 20, static_cast<std::uint8_t>(level));
        Bytes to(from.size());
        kernels::blur_bytes({50, 20}, 1, 0.7, from, to);
        EXPECT_EQ(from, to);
    }
}

}  // namespace
}  // namespace vvr
