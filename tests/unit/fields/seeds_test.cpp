#include "core/fields/seeds.h"

#include <map>
#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace vvr {
namespace {

/// All that moves or not, on a grid.
fields::SeedOptions chosen(const char* selection, int grid = 10) {
    return {.grid = grid, .min_magnitude = 0, .select = fields::parse_seed_selection(selection)};
}

/// A field whose flow, difference and age all grow in different directions.
struct Example {
    static constexpr Size size{60, 40};
    fields::Flow flow{Plane<float>(size), Plane<float>(size)};
    Plane<std::uint8_t> object{size};
    Plane<std::uint16_t> age{size};

    Example() {
        for (int j = 0; j < size.height; ++j) {
            for (int i = 0; i < size.width; ++i) {
                flow.u.at(i, j) = static_cast<float>(i) / 10;
                flow.v.at(i, j) = -1;
                object.at(i, j) = static_cast<std::uint8_t>(j < 10 ? 0 : 5 * j);
                age.at(i, j) = static_cast<std::uint16_t>(100 - i - j);
            }
        }
    }

    std::vector<fields::Seed> seeds(const fields::SeedOptions& options, std::int64_t frame = 0) const {
        return fields::make_seeds({frame, flow, object, age}, options);
    }
};

TEST(Seeds, LieOnTheGridWhereTheObjectMoves) {
    const Example example;
    const std::vector<fields::Seed> seeds = example.seeds({.grid = 10, .min_magnitude = 3, .select = {}});
    std::set<std::pair<float, float>> points;
    for (const fields::Seed& seed : seeds) {
        EXPECT_EQ(static_cast<int>(seed.x) % 10, 5);
        EXPECT_EQ(static_cast<int>(seed.y) % 10, 5);
        EXPECT_GE(seed.y, 10) << "above is no object";
        EXPECT_GE(seed.x, 30) << "to the left it is slower than 3";
        EXPECT_FLOAT_EQ(seed.u, seed.x / 10);
        EXPECT_EQ(seed.v, -1);
        EXPECT_EQ(seed.flags, fields::SeedFlags{});
        points.insert({seed.x, seed.y});
    }
    EXPECT_EQ(points.size(), 3U * 3);
    EXPECT_EQ(example.seeds({.grid = 10, .min_magnitude = 0, .select = {}}).size(), 6U * 3);
    EXPECT_TRUE(example.seeds({.grid = 10, .min_magnitude = 100, .select = {}}).empty());
    EXPECT_EQ(example.seeds({.grid = 1, .min_magnitude = 0, .select = {}}).size(), 60U * 30)
        << "a grid of one is every pixel";
    EXPECT_TRUE(example.seeds({.grid = 200, .min_magnitude = 0, .select = {}}).empty());
}

TEST(Seeds, AreSortedByTheCriterion) {
    const Example example;
    const auto sorted = [&](const char* order, auto key) {
        const std::vector<fields::Seed> seeds =
            example.seeds({.grid = 10, .min_magnitude = 0, .order = order, .select = {}});
        ASSERT_EQ(seeds.size(), 18U);
        for (std::size_t k = 1; k < seeds.size(); ++k) EXPECT_GE(key(seeds[k - 1]), key(seeds[k])) << order << " " << k;
    };
    sorted("magnitude", [](const fields::Seed& s) { return s.u; });
    sorted("difference", [](const fields::Seed& s) { return s.y; });
    sorted("age", [](const fields::Seed& s) { return -s.x - s.y; });
}

TEST(Seeds, FirstTakesTheMostImportant) {
    const Example example;
    const std::vector<fields::Seed> all = example.seeds(chosen("all"));
    const std::vector<fields::Seed> first = example.seeds(chosen("first:5"));
    ASSERT_EQ(first.size(), 5U);
    EXPECT_TRUE(std::equal(first.begin(), first.end(), all.begin()));
    EXPECT_EQ(example.seeds(chosen("first:1000")), all);
    EXPECT_TRUE(example.seeds(chosen("first:0")).empty());
}

TEST(Seeds, RandomRepeatsWithItsNumber) {
    const Example example;
    const fields::SeedOptions options = chosen("random:20", 4);
    const std::vector<fields::Seed> once = example.seeds(options);
    ASSERT_EQ(once.size(), 20U);
    EXPECT_EQ(example.seeds(options), once);
    EXPECT_NE(example.seeds(options, 1), once) << "another frame, other points";
    EXPECT_NE(example.seeds(chosen("random:20:2", 4)), once);
    for (std::size_t k = 1; k < once.size(); ++k) EXPECT_GE(once[k - 1].u, once[k].u) << "still in order";
    EXPECT_EQ(example.seeds(chosen("random:100000", 4)).size(), example.seeds(chosen("all", 4)).size());
}

// Over many frames each of the 18 points is drawn about as often as any other.
TEST(Seeds, RandomIsFair) {
    const Example example;
    std::map<std::pair<float, float>, int> drawn;
    for (int frame = 0; frame < 3000; ++frame) {
        for (const fields::Seed& s : example.seeds(chosen("random:3"), frame)) ++drawn[{s.x, s.y}];
    }
    ASSERT_EQ(drawn.size(), 18U);
    for (const auto& [point, count] : drawn) EXPECT_NEAR(count, 500, 100) << point.first << ", " << point.second;
}

TEST(Age, StaysAtItsMaximum) {
    const Plane<std::uint16_t> before({2, 1}, 65'535);
    Plane<std::uint8_t> object({2, 1});
    object.at(1, 0) = 1;
    EXPECT_EQ(fields::aged(before, object).at(0, 0), 0);
    EXPECT_EQ(fields::aged(before, object).at(1, 0), 65'535);
    EXPECT_EQ(fields::aged({}, object).at(1, 0), 1) << "in the first frame";
}

}  // namespace
}  // namespace vvr
