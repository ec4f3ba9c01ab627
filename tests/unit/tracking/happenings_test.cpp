// Events of small scenes of one happening each, of which it is known to the frame what happens.
#include "tests/scene/happenings.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/tracking/path.h"
#include "tests/scene/camera.h"
#include "tests/unit/tracking/found.h"

namespace vvr {
namespace {

using test::distance_to;
using test::expect_frames;
using test::Found;
using test::found_in;
using test::kinds_of;
using test::small;

/// Seeds from the first on: one in the default set, four more each night.
class EverySeed : public testing::TestWithParam<std::uint64_t> {};
INSTANTIATE_TEST_SUITE_P(First, EverySeed, testing::Range<std::uint64_t>(1, 2));
INSTANTIATE_TEST_SUITE_P(Nightly, EverySeed, testing::Range<std::uint64_t>(2, 6));

TEST_P(EverySeed, OfTenCrossingsLeavesTwoPeopleTwo) {
    const Found found = found_in(generator::make_ten_crossings(small(GetParam())));
    ASSERT_EQ(found.all.events.size(), 2U);
    const bool first_is_0 = distance_to(found.all.events[0], found.scene, "person 0") <
                            distance_to(found.all.events[0], found.scene, "person 1");
    // Anyone who swapped even once would be 70 pixels off for a tenth of the time.
    EXPECT_LT(distance_to(found.all.events[0], found.scene, first_is_0 ? "person 0" : "person 1"), 10);
    EXPECT_LT(distance_to(found.all.events[1], found.scene, first_is_0 ? "person 1" : "person 0"), 10);
}

TEST(GroupThatSplits, IsTwoFromTheBeginning) {
    const Found found = found_in(generator::make_group_splits(small()));
    ASSERT_EQ(found.all.events.size(), 2U);
    for (const tracking::Event& event : found.all.events) {
        EXPECT_EQ(event.kind, tracking::EventKind::moved);
        EXPECT_NEAR(static_cast<double>(event.first.frame), 6, test::half_a_second);
    }
}

TEST(Train, IsOneAndHidesNobody) {
    const Found found = found_in(generator::make_train(small()));
    ASSERT_EQ(kinds_of(found.all.events), (std::vector{tracking::EventKind::stood, tracking::EventKind::moved}));
    ASSERT_EQ(found.all.events[0].stays.size(), 1U);
    expect_frames(found.all.events[0].stays[0], generator::train_stands());
}

TEST(PaleBag, IsOneThingThatWasLeft) {
    const Found found = found_in(generator::make_pale_bag(small()));
    ASSERT_EQ(kinds_of(found.all.events), (std::vector{tracking::EventKind::moved, tracking::EventKind::left}));
    const tracking::Event& bag = found.all.events[1];
    expect_frames(bag, generator::pale_bag_stands());
    EXPECT_EQ(bag.by, 0U);
    ASSERT_TRUE(bag.alone_since);
    EXPECT_GT(bag.alone_since->frame, 150) << "then its owner goes";
    EXPECT_LT(bag.alone_since->frame, 220);
    ASSERT_TRUE(bag.portrait);
    EXPECT_GT(bag.portrait->box.height(), 18) << "both its stripes";
}

TEST(TakenBox, IsTakenAndNotLeft) {
    const Found found = found_in(generator::make_taken_box(small()));
    ASSERT_EQ(kinds_of(found.all.events), (std::vector{tracking::EventKind::moved, tracking::EventKind::taken}))
        << found;
    const tracking::Event& box = found.all.events[1];
    expect_frames(box, generator::box_is_gone());
    EXPECT_EQ(box.by, 0U);
    EXPECT_TRUE(box.stays.empty()) << "nothing stands there";
}

TEST_P(EverySeed, OfRainIsNoneAndHidesNobody) {
    const Found found = found_in(generator::make_rain(small(GetParam(), 5)));
    ASSERT_EQ(found.all.events.size(), 1U);
    // Drops that touch a person are taken for parts of them.
    EXPECT_LT(distance_to(found.all.events[0], found.scene, "person"), 20);
}

TEST(Crowd, LeavesNothing) {
    for (const tracking::Event& event : found_in(generator::make_crowd(small())).all.events) {
        EXPECT_EQ(event.kind, tracking::EventKind::moved) << event.first.frame;
    }
}

template <class Part>
generator::Interval interval_of(const Part& part) {
    return {static_cast<int>(part.first.frame), static_cast<int>(part.last.frame)};
}

// A picture of half the size would have too few corners to know the camera's motion by.
TEST_P(EverySeed, OfAShakingCameraHasTheEventsOfAStillOne) {
    const generator::Options options{.size = {256, 192}, .seed = GetParam(), .detail = 6};
    for (const auto& make : {generator::make_stands_long, generator::make_pale_bag, generator::make_still}) {
        const generator::Scene scene = make(options);
        const std::vector<tracking::Event> still = found_in(scene).all.events;
        const std::vector<tracking::Event> shaken = found_in(generator::make_shaken(scene)).all.events;
        ASSERT_EQ(kinds_of(shaken), kinds_of(still));
        for (std::size_t k = 0; k < still.size(); ++k) {
            expect_frames(shaken[k], interval_of(still[k]));
            ASSERT_EQ(shaken[k].stays.size(), still[k].stays.size());
            for (std::size_t s = 0; s < still[k].stays.size(); ++s) {
                expect_frames(shaken[k].stays[s], interval_of(still[k].stays[s]));
            }
        }
    }
}

TEST(ShakingCamera, ShowsWhatIsTaken) {
    const Found box = found_in(generator::make_shaken(generator::make_taken_box({.size = {256, 192}, .detail = 6})));
    ASSERT_EQ(kinds_of(box.all.events), (std::vector{tracking::EventKind::moved, tracking::EventKind::taken}));
    expect_frames(box.all.events[1], generator::box_is_gone());
}

TEST(WhoStandsLong, IsOneThatStood) {
    for (const std::string reference : {"median", "running"}) {
        const Found found = found_in(generator::make_stands_long(small()), reference);
        ASSERT_EQ(kinds_of(found.all.events), std::vector{tracking::EventKind::stood}) << reference;
        ASSERT_EQ(found.all.events[0].stays.size(), 1U) << reference;
        expect_frames(found.all.events[0].stays[0], generator::long_stand());
    }
}

// 12.5, 5 and 1 frames per second, beside 25. At the lowest rate, people go their own width from frame to frame.
TEST(LowRates, HaveTheEventsOfTheFullRate) {
    for (const auto& make : {generator::make_stands, generator::make_pale_bag}) {
        const generator::Scene scene = make(small());
        const std::vector<tracking::Event> full = found_in(scene).all.events;
        for (const int every : {2, 5, 25}) {
            const Found found = found_in(generator::make_thinned(scene, every));
            ASSERT_EQ(kinds_of(found.all.events), kinds_of(full)) << every << found;
            for (std::size_t k = 0; k < full.size(); ++k) {
                // What lies still is known by a second frame.
                const int frames = row_of(full[k].kind).is_thing ? 2 : 1;
                EXPECT_NEAR(found.all.events[k].first.seconds, full[k].first.seconds, frames * every / 25.0) << found;
            }
        }
    }
}

TEST(Labels, SayWhosePixelsTheyAre) {
    const Found found = found_in(generator::make_ten_crossings(small()));
    ASSERT_EQ(found.all.events.size(), 2U);
    const auto places = tracking::events_of_tracks(found.all.events);
    ASSERT_EQ(found.labels.size(), static_cast<std::size_t>(found.scene.frames()));
    const tracking::FrameLabels& labels = found.labels[30];
    std::set<std::size_t> seen;
    for (const fields::LabelRun& run : labels.runs) {
        ASSERT_LT(run.track, places.size());
        ASSERT_TRUE(places[run.track]);
        seen.insert(*places[run.track]);
        const double middle = 0.5 * (run.first + run.last);
        EXPECT_NEAR(middle, tracking::place_at(found.all.events[*places[run.track]].path, labels.at.frame).x, 25);
    }
    EXPECT_EQ(seen.size(), 2U);
}

}  // namespace
}  // namespace vvr
