#include <random>

#include <gtest/gtest.h>

#include "core/annotation/portraits.h"

namespace vvr {
namespace {

constexpr PixelBox row{10, 50, 1270, 150};
constexpr int gap = 12;

annotation::WantedPortrait wanted_at(std::size_t number, const glm::dvec2& pixel) {
    return {number, {{pixel, 0}}};
}

/// As trails of a horseshoe: later is further to the right, each anywhere in height.
std::vector<annotation::WantedPortrait> random_portraits(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> time(0, 100);
    std::uniform_real_distribution<double> height(0, 1);
    std::vector<annotation::WantedPortrait> wanted;
    for (int i = 0; i < count; ++i) {
        const double middle = time(random);
        annotation::WantedPortrait one{static_cast<std::size_t>(1000 * middle), {}};
        for (double at = middle - 10; at <= middle + 10; at += 2) {
            one.anchors.push_back({{60 + 11 * at + 200 * height(random), 200 + 400 * height(random)}, 0});
        }
        wanted.push_back(std::move(one));
    }
    return wanted;
}

TEST(PortraitRow, HasNoOverlapAndNoCrossingWhateverTheEvents) {
    std::mt19937 random(7);
    for (int round = 0; round < 300; ++round) {
        const std::vector<annotation::WantedPortrait> wanted = random_portraits(1 + round % 40, random);
        const std::vector<annotation::PlacedPortrait> placed = annotation::place_portraits(wanted, row, gap, {});
        ASSERT_FALSE(placed.empty());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            EXPECT_TRUE(row.contains(placed[i].still));
            EXPECT_EQ(placed[i].still.width(), row.height());
            if (i == 0) continue;
            EXPECT_GE(placed[i].still.left, placed[i - 1].still.right + gap - 1);
            EXPECT_LE(wanted[placed[i - 1].wanted].number, wanted[placed[i].wanted].number);
            for (std::size_t k = 0; k < i; ++k) {
                EXPECT_FALSE(annotation::lines_cross(placed[i].from, placed[i].to, placed[k].from, placed[k].to))
                    << round;
            }
        }
    }
}

TEST(PortraitRow, HasRoomForPairs) {
    std::mt19937 random(5);
    for (int round = 0; round < 100; ++round) {
        std::vector<annotation::WantedPortrait> wanted = random_portraits(12, random);
        for (std::size_t k = 0; k < 3; ++k) wanted[k].wide = 2;
        const std::vector<annotation::PlacedPortrait> placed = annotation::place_portraits(wanted, row, gap, {});
        ASSERT_FALSE(placed.empty());
        for (std::size_t i = 0; i < placed.size(); ++i) {
            EXPECT_TRUE(row.contains(placed[i].still));
            EXPECT_EQ(placed[i].still.width(), row.height() * wanted[placed[i].wanted].wide);
            if (i == 0) continue;
            EXPECT_GE(placed[i].still.left, placed[i - 1].still.right + gap - 1);
        }
    }
}

TEST(PortraitRow, IsTheSameEachTime) {
    std::mt19937 random(3);
    const std::vector<annotation::WantedPortrait> wanted = random_portraits(30, random);
    const std::vector<annotation::PlacedPortrait> once = annotation::place_portraits(wanted, row, gap, {});
    const std::vector<annotation::PlacedPortrait> again = annotation::place_portraits(wanted, row, gap, {});
    ASSERT_EQ(once.size(), again.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(once[i].wanted, again[i].wanted);
        EXPECT_EQ(once[i].still, again[i].still);
        EXPECT_EQ(once[i].to, again[i].to);
    }
}

TEST(PortraitRow, StandsAboveItsTrail) {
    const std::vector<annotation::WantedPortrait> wanted{wanted_at(5, {640, 400})};
    const std::vector<annotation::PlacedPortrait> placed = annotation::place_portraits(wanted, row, gap, {});
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_NEAR(placed[0].from.x, 640, 1);
    EXPECT_EQ(placed[0].to, glm::dvec2(640, 400));
}

// The more important ones come first in the list, whatever their numbers.
TEST(PortraitRow, IsInTheOrderOfNumbers) {
    std::vector<annotation::WantedPortrait> wanted;
    for (const std::size_t number : {4U, 2U, 1U, 3U}) wanted.push_back(wanted_at(number, {100 + 250 * number, 400}));
    const std::vector<annotation::PlacedPortrait> placed = annotation::place_portraits(wanted, row, gap, {});
    ASSERT_EQ(placed.size(), 4U);
    for (std::size_t i = 0; i < placed.size(); ++i) EXPECT_EQ(wanted[placed[i].wanted].number, i + 1);
}

TEST(PortraitRow, GivesThePlaceOfACrossingLineToTheNext) {
    // The second is later, but its trail is left of the first's, far above: from its place on the right its line must
    // cross the first's.
    const std::vector<annotation::WantedPortrait> wanted{wanted_at(1, {900, 600}), wanted_at(2, {100, 300}),
                                                         wanted_at(3, {1200, 500})};
    const std::vector<annotation::PlacedPortrait> placed = annotation::place_portraits(wanted, row, gap, {});
    ASSERT_EQ(placed.size(), 2U);
    EXPECT_EQ(placed[0].wanted, 0U);
    EXPECT_EQ(placed[1].wanted, 2U);
}

TEST(PortraitRow, LeadsAroundText) {
    const annotation::WantedPortrait one{5, {{{640, 400}, 0}, {{700, 420}, 0}}};
    const std::vector<PixelBox> text{{630, 200, 650, 220}};
    const std::vector<annotation::PlacedPortrait> placed =
        annotation::place_portraits(std::vector{one}, row, gap, text);
    ASSERT_EQ(placed.size(), 1U);
    EXPECT_EQ(placed[0].to, glm::dvec2(700, 420));
}

TEST(PortraitRow, HoldsWhatItHasRoomFor) {
    std::vector<annotation::WantedPortrait> wanted;
    for (std::size_t i = 0; i < 30; ++i) wanted.push_back(wanted_at(i, {20 + 40 * i, 400}));
    EXPECT_EQ(annotation::place_portraits(wanted, row, gap, {}).size(), 11U);  // (1260 + 12) / (100 + 12)
    EXPECT_TRUE(annotation::place_portraits(wanted, {0, 0, 50, 100}, gap, {}).empty());
    EXPECT_TRUE(annotation::place_portraits({}, row, gap, {}).empty());
}

}  // namespace
}  // namespace vvr
