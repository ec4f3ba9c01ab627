// The events of scenes of which it is known what happens.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/planes.h"
#include "tests/unit/tracking/found.h"

namespace vvr {
namespace {

constexpr double frames_off = 5;
constexpr double pixels_off = 5;

std::vector<tracking::Event> events_of(const generator::Scene& scene) {
    return test::found_in(scene).all.events;
}

/// When each object can be seen: enough of it to be told from nothing.
std::map<std::string, std::vector<generator::Interval>> visits_of(const generator::Scene& scene) {
    constexpr int least = 30;  // pixels
    std::map<std::string, std::vector<generator::Interval>> visits;
    for (int f = 0; f < scene.frames(); ++f) {
        for (const generator::Object& object : scene.truth(f).objects) {
            if (test::lit(object.mask) < least) continue;
            std::vector<generator::Interval>& own = visits[object.name];
            if (own.empty() || own.back().last < f - 1) own.push_back({f, f});
            own.back().last = f;
        }
    }
    return visits;
}

void expect_visit(const auto& part, const generator::Interval& expected) {
    test::expect_frames(part, expected, frames_off);
}

/// Frames, seed and noise.
class LeftBagEvents : public testing::TestWithParam<std::tuple<int, std::uint64_t, double>> {};

TEST_P(LeftBagEvents, AreTwoVisitsAndTheBagBetweenThem) {
    const auto& [frames, seed, noise] = GetParam();
    const generator::Options options{.frames = frames, .seed = seed, .noise = noise};
    const generator::Scene scene = generator::make_left_bag(options);
    const generator::LeftBag facts = generator::left_bag_facts(options);
    const std::vector<tracking::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 3U);

    const std::vector<generator::Interval> visits = visits_of(scene)["person"];
    ASSERT_EQ(visits.size(), 2U);
    expect_visit(events[0], visits[0]);
    expect_visit(events[2], visits[1]);

    const tracking::Event& bag = events[1];
    expect_visit(bag, {facts.put_down, facts.taken_up - 1});
    ASSERT_EQ(bag.stays.size(), 1U);
    expect_visit(bag.stays[0], {facts.put_down, facts.taken_up - 1});
    EXPECT_NEAR(bag.stays[0].place.x, facts.x, pixels_off);
    EXPECT_NEAR(bag.stays[0].place.y, facts.y, pixels_off);
    EXPECT_LT(bag.path_length, pixels_off);
    EXPECT_EQ(bag.from, 0U);
    EXPECT_EQ(bag.into, 2U);

    // He goes through the picture; his middle is that of what he carries as well.
    EXPECT_GT(events[0].path_length, 0.9 * scene.size().width);
    for (const tracking::PathPoint& point : events[0].path) {
        const generator::Truth truth = scene.truth(static_cast<int>(point.at.frame));
        const generator::Object* const person = truth.find("person");
        ASSERT_NE(person, nullptr);
        if (person->x < 30 || person->x > scene.size().width - 30 || std::abs(person->x - facts.x) < 40) continue;
        EXPECT_NEAR(point.place.x, person->x, 10) << point.at.frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Quick, LeftBagEvents, testing::Values(std::tuple(600, 2, 5)));
INSTANTIATE_TEST_SUITE_P(Nightly, LeftBagEvents,
                         testing::Values(std::tuple(600, 1, 0), std::tuple(1600, 1, 0), std::tuple(1600, 3, 0),
                                         std::tuple(1600, 1, 5)));

TEST(StillEvents, NoiseIsNone) {
    for (const double noise : {0.0, 5.0, 8.0}) {
        generator::Options options{.frames = 150, .noise = noise};
        EXPECT_TRUE(events_of(generator::make_still(options)).empty()) << noise;
    }
}

TEST(FallOnFloorEvents, AreOneThatLiesStill) {
    const generator::Scene scene = generator::make_fall_on_floor({});
    const generator::FallOnFloor facts = generator::fall_on_floor_facts({});
    const std::vector<tracking::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 1U);
    const std::vector<generator::Interval> visits = visits_of(scene)["person"];
    expect_visit(events[0], {visits.front().first, visits.back().last});
    ASSERT_EQ(events[0].stays.size(), 1U);
    expect_visit(events[0].stays[0], {facts.lies, facts.gets_up});
    EXPECT_NEAR(events[0].stays[0].place.x, facts.x, pixels_off);
    EXPECT_NEAR(events[0].stays[0].place.y, facts.y, pixels_off);
}

/// The parameter is the noise.
class TwoWalkersCrossEvents : public testing::TestWithParam<double> {};

TEST_P(TwoWalkersCrossEvents, AreTwoThatKeepTheirWays) {
    const generator::Scene scene = generator::make_two_walkers_cross({.noise = GetParam()});
    const std::vector<tracking::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 2U);
    const auto visits = visits_of(scene);
    for (const std::string name : {"walker 0", "walker 1"}) {
        const std::vector<generator::Interval>& own = visits.at(name);
        const bool rightward = scene.truth(own.front().first + 20).find(name)->vx > 0;
        const auto event = std::ranges::find_if(events, [&](const tracking::Event& e) {
            return (e.path.back().place.x > e.path.front().place.x) == rightward;
        });
        ASSERT_NE(event, events.end()) << name;
        expect_visit(*event, {own.front().first, own.back().last});
        EXPECT_GT(event->path_length, 0.9 * scene.size().width);
    }
}

INSTANTIATE_TEST_SUITE_P(Quick, TwoWalkersCrossEvents, testing::Values(5.0));
INSTANTIATE_TEST_SUITE_P(Nightly, TwoWalkersCrossEvents, testing::Values(0.0));

TEST(WalkersEvents, AreAsManyAsWalkers) {
    const generator::Scene scene = generator::make_walkers({});
    const std::vector<tracking::Event> events = events_of(scene);
    ASSERT_EQ(events.size(), 6U);
    const auto visits = visits_of(scene);
    for (int k = 0; k < 6; ++k) {
        const generator::Interval visit = visits.at("walker " + std::to_string(k)).front();
        // One of them comes in behind another, so his beginning is not so well known.
        const bool there = std::ranges::any_of(events, [&](const tracking::Event& event) {
            return std::abs(event.first.frame - visit.first) <= 12 && std::abs(event.last.frame - visit.last) <= 5;
        });
        EXPECT_TRUE(there) << "walker " << k << ": " << visit.first << " to " << visit.last;
    }
}

}  // namespace
}  // namespace vvr
