#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/tracking/patch.h"
#include "core/tracking/path.h"
#include "core/tracking/pixel_history.h"
#include "tests/support/planes.h"
#include "tests/unit/tracking/found.h"

namespace vvr {
namespace {

using test::at;

TEST(FindBlobs, JoinsWhatIsNearAndLeavesOutWhatIsSmall) {
    Plane<std::uint8_t> field({60, 40});
    fill(field, {5, 5, 10, 12}, 90);
    fill(field, {12, 5, 14, 12}, 200);
    fill(field, {40, 20, 50, 30}, 70);
    fill(field, {30, 2, 31, 3}, 255);
    const tracking::Blobs blobs = tracking::find_blobs(field, {1, 1}, 4);
    ASSERT_EQ(blobs.patches.size(), 2U);
    EXPECT_EQ(blobs.patches[0].box, (PixelBox{5, 5, 14, 12}));
    EXPECT_EQ(blobs.patches[0].area, 7 * 7);
    EXPECT_EQ(blobs.patches[0].at(13, 5), 200);
    EXPECT_EQ(blobs.patches[0].at(11, 5), 0);
    EXPECT_EQ(blobs.patches[0].at(45, 25), 0);
    EXPECT_DOUBLE_EQ(blobs.patches[1].centre.x, 44.5);
    EXPECT_DOUBLE_EQ(blobs.patches[1].centre.y, 24.5);
    EXPECT_EQ(blobs.labels.at(4, 4), 1) << "labels reach farther than the pixels";
    EXPECT_EQ(blobs.labels.at(30, 2), 0);
    EXPECT_TRUE(tracking::find_blobs(Plane<std::uint8_t>({8, 8}), {1, 1}, 4).patches.empty());
}

TEST(Steadiness, KnowsSinceWhenThroughNoiseAndShortGaps) {
    tracking::Steadiness steadiness;
    Plane<std::uint8_t> field({1, 1});
    const auto show = [&](std::int64_t frame, int value) {
        field.at(0, 0) = static_cast<std::uint8_t>(value);
        steadiness.add(field, at(frame));
    };
    for (int f = 0; f < 10; ++f) show(f, 0);
    EXPECT_EQ(steadiness.at(0, 0).level, 0);
    for (int f = 10; f < 30; ++f) show(f, 200);
    for (int f = 30; f < 60; ++f) show(f, f == 40 || f == 41 ? 0 : 100 + (f % 3) * 10);
    EXPECT_EQ(steadiness.at(0, 0).since.frame, 30) << "another value is another object";
    EXPECT_NEAR(steadiness.at(0, 0).level, 110, 12);
    for (int f = 60; f < 63; ++f) show(f, 0);
    EXPECT_EQ(steadiness.at(0, 0).level, 0);
}

TEST(Path, IsCoarseHoweverLongItIs) {
    tracking::Path path;
    for (int f = 0; f < 100'000; ++f) path.add(at(f), {0.01 * f, 5});
    const std::vector<tracking::PathPoint> points = path.points();
    EXPECT_LE(points.size(), 129U);
    EXPECT_GT(points.size(), 60U);
    EXPECT_EQ(points.front().at.frame, 0);
    EXPECT_EQ(points.back().at.frame, 99'999);
    EXPECT_NEAR(tracking::length_of(points), 999.99, 1e-6);
}

TEST(Path, OfWhatStandsIsTwoPoints) {
    tracking::Path path;
    for (int f = 0; f < 1000; ++f) path.add(at(f), {7, 5});
    const std::vector<tracking::PathPoint> points = path.points();
    ASSERT_LE(points.size(), 3U);
    EXPECT_EQ(points.back().at.frame, 999);
    EXPECT_EQ(tracking::length_of(points), 0);
}

TEST(Stays, AreWhereTheMiddleKeepsItsPlace) {
    tracking::Stays stays(2);
    for (int f = 0; f < 300; ++f) {
        const double x = f < 100 ? f : f < 200 ? 100 + std::sin(f) : f - 100;
        stays.add(at(f), {x, 0}, {}, 3);
    }
    const std::vector<tracking::Stay> found = stays.finish();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(static_cast<double>(found[0].first.frame), 98, 3);
    EXPECT_NEAR(static_cast<double>(found[0].last.frame), 202, 3);
    EXPECT_NEAR(found[0].place.x, 100, 3);
}

TEST(Stays, ThatAreKnownExactlyReplaceThoseTheyMeet) {
    tracking::Stays stays(2);
    for (int f = 0; f < 300; ++f) stays.add(at(f), {f < 100 ? 0 : f < 200 ? 50 : 100, 0}, {}, 3);
    stays.add_exactly({at(150), at(280), {60, 0}, {}});
    const std::vector<tracking::Stay> found = stays.finish();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].last.frame, 99);
    EXPECT_EQ(found[1].first.frame, 150);
}

}  // namespace
}  // namespace vvr
