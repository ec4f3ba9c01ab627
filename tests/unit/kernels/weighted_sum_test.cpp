#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/kernels/rows.h"

namespace vvr {
namespace {

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
