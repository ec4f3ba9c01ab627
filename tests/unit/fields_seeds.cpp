#include <gtest/gtest.h>

#include "core/fields/seeds.h"

namespace vvr {
namespace {

TEST(Seeds, LieOnTheGridWhereSomethingMoves) {
    constexpr Size size{40, 30};
    Flow flow{Plane<float>(size, 3), Plane<float>(size, -4)};
    Plane<std::uint8_t> object(size);
    object.at(15, 5) = 1;
    object.at(15, 15) = 255;
    object.at(16, 15) = 255;
    object.at(35, 25) = 255;
    flow.u.at(35, 25) = 0.1F;
    flow.v.at(35, 25) = 0;
    const std::vector<Seed> seeds = make_seeds(flow, object, {.grid = 10, .min_magnitude = 0.3});
    ASSERT_EQ(seeds.size(), 2U);
    EXPECT_EQ(seeds[0].x, 15);
    EXPECT_EQ(seeds[0].y, 5);
    EXPECT_EQ(seeds[1].y, 15);
    EXPECT_EQ(seeds[1].u, 3);
    EXPECT_EQ(seeds[1].v, -4);
    EXPECT_EQ(make_seeds(flow, object, {.grid = 10, .min_magnitude = 5.01}).size(), 0U);
    EXPECT_EQ(make_seeds(flow, object, {.grid = 10, .min_magnitude = 0}).size(), 3U);
}

TEST(Seeds, AGridOfOneIsEveryPixel) {
    constexpr Size size{3, 1};
    const Flow flow{Plane<float>(size, 1), Plane<float>(size, 0)};
    EXPECT_EQ(make_seeds(flow, Plane<std::uint8_t>(size, 1), {.grid = 1, .min_magnitude = 0.3}).size(), 3U);
    EXPECT_EQ(make_seeds(flow, Plane<std::uint8_t>(size, 1), {.grid = 100, .min_magnitude = 0.3}).size(), 0U);
}

}  // namespace
}  // namespace vvr
