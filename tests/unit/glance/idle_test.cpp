#include <gtest/gtest.h>

#include "core/glance/time_strip.h"

namespace vvr {
namespace {

TEST(IdlePeriods, AreTheRestOfTheClip) {
    const std::vector<glance::Period> idle = glance::idle_periods({{5, 8}, {3, 20}, {30, 40}}, 0, 50);
    ASSERT_EQ(idle.size(), 3U);
    EXPECT_EQ(idle[0].begin, 0);
    EXPECT_EQ(idle[0].end, 3);
    EXPECT_EQ(idle[1].begin, 20);
    EXPECT_EQ(idle[1].end, 30);
    EXPECT_EQ(idle[2].begin, 40);
    EXPECT_EQ(idle[2].end, 50);
    EXPECT_EQ(glance::idle_periods({}, 0, 50).size(), 1U);
    EXPECT_TRUE(glance::idle_periods({{0, 50}}, 0, 50).empty());
}

/// A hundred frames, ten per second. In some of them, every `each`-th pixel of a square differs from the empty scene.
bricks::Volume changed_in(int first, int last, int each) {
    constexpr Size size{96, 64};
    bricks::VolumeOptions options;
    options.keep_owners = true;
    bricks::Volume volume(size, options);
    for (int i = 0; i < 100; ++i) {
        fields::Field field;
        field.index = i;
        field.pts = i / 10.0;
        field.scalar = Plane<std::uint8_t>(size);
        for (int k = 0; k < 16 * 16 && i >= first && i <= last; k += each)
            field.scalar.at(20 + k % 16, 20 + k / 16) = 200;
        volume.add(field);
    }
    return volume;
}

TEST(UnexplainedPeriods, AreThoseWithAThingThatIsNoObject) {
    const std::vector<glance::Period> periods =
        glance::unexplained_periods(changed_in(30, 49, 1), bricks::no_identities);
    ASSERT_EQ(periods.size(), 1U);
    EXPECT_NEAR(periods[0].begin, 3, 1e-9);
    EXPECT_NEAR(periods[0].end, 5, 1e-9);
}

TEST(UnexplainedPeriods, DoNotCountNoiseAndFlashes) {
    EXPECT_TRUE(glance::unexplained_periods(changed_in(30, 49, 7), bricks::no_identities).empty());
    EXPECT_TRUE(glance::unexplained_periods(changed_in(30, 34, 1), bricks::no_identities).empty());
}

}  // namespace
}  // namespace vvr
