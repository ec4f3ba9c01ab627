// What is said to be left or taken in small scenes of which it is known.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/scene/camera.h"
#include "tests/unit/tracking/found.h"

namespace vvr {
namespace {

using test::expect_frames;
using test::Found;
using test::found_in;
using test::kinds_of;
using test::small;
using tracking::EventKind;

constexpr double second = 25;  // frames

bool claims_a_thing(const Found& found) {
    return std::ranges::any_of(found.all.events, [](const tracking::Event& e) { return row_of(e.kind).is_thing; });
}

/// One box over the seconds, and nothing beyond the line but a few pixels around it.
void expect_clock(const Found& found, int lower = 0) {
    ASSERT_EQ(found.all.overlays.size(), 1U) << found;
    const PixelBox& box = found.all.overlays[0];
    constexpr int rim = 5;
    EXPECT_TRUE(generator::clock_line().translated(0, lower).inflated(rim, rim).contains(box)) << found;
    EXPECT_TRUE(box.intersects(generator::clock_seconds().translated(0, lower))) << found;
}

TEST(Clock, IsAnOverlayAndNoEvent) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_clock(small(seed, seed == 2 ? 4 : 0)));
        expect_clock(found);
        // Noise may hide the rim of a digit.
        EXPECT_TRUE(seed == 2 || found.all.overlays[0].contains(generator::clock_seconds())) << found;
        EXPECT_TRUE(found.all.events.empty()) << seed << found;
        EXPECT_TRUE(found.all.changes.empty()) << seed << found;
    }
}

TEST(ClockAndWalker, IsAnOverlayAndOneEventOfThePerson) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_clock_and_walker(small(seed)));
        expect_clock(found, 117);
        ASSERT_EQ(kinds_of(found.all.events), std::vector{EventKind::moved}) << seed << found;
        expect_frames(found.all.events[0], test::visible(found.scene, "person"));
        EXPECT_LT(test::distance_to(found.all.events[0], found.scene, "person"), 10) << seed << found;
    }
}

TEST(Balloons, AreAChange) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_balloons(small(seed)));
        // Three bunches sway. One of the second scene goes as far as people do who leave at the border.
        EXPECT_LE(found.all.events.size(), seed - 1) << seed << found;
    }
}

TEST(Lamp, LeavesAndTakesNothing) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found lamp = found_in(generator::make_lamp(small(seed)));
        EXPECT_FALSE(claims_a_thing(lamp)) << seed << lamp;
        const Found with_walker = found_in(generator::make_lamp_and_walker(small(seed)));
        EXPECT_FALSE(claims_a_thing(with_walker)) << seed << with_walker;
        // In the second scene, the person walks in the lamp's light from the first to the last.
        EXPECT_EQ(with_walker.all.events.empty(), seed == 2U) << seed << ": the person is one" << with_walker;
    }
}

TEST(WhoWaitsForAMinute, IsOneThatStood) {
    const Found found = found_in(generator::make_thinned(generator::make_waits(small()), 2));
    const generator::Interval waits = generator::minute_of_waiting();
    ASSERT_EQ(kinds_of(found.all.events), std::vector{EventKind::stood}) << found;
    expect_frames(found.all.events[0], test::visible(found.scene, "person"));
    EXPECT_NEAR(stationary_seconds(found.all.events[0]), (waits.last - waits.first) / second, 2) << found;
}

// Three visits from the first frame to where each goes, and nothing where they had been.
TEST(PeopleFromTheFirstFrame, StandAndGo) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_thinned(generator::make_people_from_first(small(seed), 1500), 2));
        EXPECT_TRUE(found.all.changes.empty()) << "no ghost" << found;
        ASSERT_EQ(kinds_of(found.all.events), std::vector(3, EventKind::stood)) << found;
        for (const std::string name : {"person 0", "person 1", "person 2"}) {
            const auto event = std::ranges::min_element(found.all.events, {}, [&](const tracking::Event& e) {
                return test::distance_to(e, found.scene, name);
            });
            EXPECT_LT(test::distance_to(*event, found.scene, name), 10) << name << found;
            expect_frames(*event, test::visible(found.scene, name));
        }
    }
}

TEST(BagOfTwo, IsLeftByOneAndTakenByTheOther) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_bag_of_two(small(seed)));
        ASSERT_EQ(kinds_of(found.all.events), (std::vector{EventKind::moved, EventKind::left, EventKind::moved}))
            << seed << found;
        const tracking::Event& bag = found.all.events[1];
        expect_frames(bag, generator::bag_of_two_stands());
        EXPECT_EQ(bag.by, 0U) << seed << found;
        EXPECT_EQ(bag.into, 2U) << seed << found;
    }
}

/// A scene of 25 frames per second from which only every n-th frame is taken; n is the parameter.
class LowRate : public testing::TestWithParam<int> {
  protected:
    /// The scene at this rate, from two different frames on.
    static std::vector<Found> thinned(const generator::Scene& scene) {
        std::vector<Found> all;
        const int every = GetParam();
        for (const int first : {0, every / 2}) all.push_back(found_in(generator::make_thinned(scene, every, first)));
        return all;
    }
};
INSTANTIATE_TEST_SUITE_P(Quick, LowRate, testing::Values(5, 25));
INSTANTIATE_TEST_SUITE_P(Nightly, LowRate, testing::Values(12, 50));

TEST_P(LowRate, LeavesNobody) {
    for (const auto make : {generator::make_long_crowd, generator::make_walkers, generator::make_stands,
                            generator::make_stands_long, generator::make_waits, generator::make_waits_early}) {
        for (const Found& found : thinned(make(small()))) EXPECT_FALSE(claims_a_thing(found)) << found;
    }
}

TEST_P(LowRate, LeavesOnlyTheBag) {
    const int every = GetParam();
    const generator::Interval stands = generator::bag_of_two_stands();
    const double first = static_cast<double>(stands.first) / every;
    const double last = static_cast<double>(stands.last) / every;
    const double off = 1 + second / every;  // frames at this rate
    for (const Found& found : thinned(generator::make_bag_of_two(small()))) {
        for (const tracking::Event& event : found.all.events) {
            EXPECT_NE(event.kind, EventKind::taken) << found;
            if (event.kind != EventKind::left) continue;
            EXPECT_GE(static_cast<double>(event.first.frame), first - off) << found;
            EXPECT_LE(static_cast<double>(event.last.frame), last + off) << found;
            EXPECT_LT(test::distance_to(event, found.scene, "bag"), 8) << found;
        }
        const auto left = std::ranges::count(found.all.events, EventKind::left, &tracking::Event::kind);
        EXPECT_LE(left, 1) << found;
        EXPECT_GE(left, every <= 5 ? 1 : 0) << found;
    }
}

TEST(ClockOverLeaves, IsOneOverlayAndNoThing) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_clock_over_leaves(small(seed)));
        ASSERT_EQ(found.all.overlays.size(), 1U) << seed << found;
        EXPECT_TRUE(found.all.overlays[0].contains(generator::clock_seconds())) << seed << found;
        EXPECT_FALSE(claims_a_thing(found)) << seed << found;
    }
}

TEST(PeopleFromTheFirstFrame, LeaveNoThingInAShortClip) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const Found found = found_in(generator::make_people_from_first(small(seed), 750));
        EXPECT_FALSE(claims_a_thing(found)) << seed << found;
    }
}

TEST(WhoWaitsForAMinute, IsNoThingIfTheyWaitForMostOfTheClip) {
    const Found found = found_in(generator::make_waits_early(small()));
    EXPECT_FALSE(claims_a_thing(found)) << found;
}

TEST(FaintBag, IsLeft) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Found found = found_in(generator::make_faint_bag(small(seed, seed == 2 ? 3 : 0)));
        ASSERT_EQ(kinds_of(found.all.events), (std::vector{EventKind::moved, EventKind::left})) << seed << found;
        const tracking::Event& bag = found.all.events[1];
        expect_frames(bag, generator::faint_bag_stands(), second);
        EXPECT_EQ(bag.by, 0U) << seed << found;
    }
}

}  // namespace
}  // namespace vvr
