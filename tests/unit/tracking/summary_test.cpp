// What is made of events for those who look at many: ways of few points, and clutter.
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/tracking/event.h"
#include "core/tracking/path.h"

namespace vvr {
namespace {

/// Where a simplified way has an object at a time.
std::pair<double, double> place_at(const std::vector<tracking::Waypoint>& way, int time) {
    for (std::size_t k = 1; k < way.size(); ++k) {
        const tracking::Waypoint& a = way[k - 1];
        const tracking::Waypoint& b = way[k];
        if (time > b.time) continue;
        const double share = static_cast<double>(time - a.time) / (b.time - a.time);
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }
    return {way.back().x, way.back().y};
}

TEST(Way, KeepsEveryMomentsPlaceWithinTheTolerance) {
    std::mt19937 random(7);
    std::normal_distribution<double> step(0, 9);
    for (int round = 0; round < 50; ++round) {
        std::vector<tracking::Waypoint> way;
        double x = 500;
        double y = 500;
        for (int time = 0; time < 300; time += 5) {
            way.push_back({time, static_cast<int>(x), static_cast<int>(y)});
            x += step(random);
            y += step(random);
        }
        const std::vector<tracking::Waypoint> few = tracking::simplified(way, 12);
        EXPECT_LT(few.size(), way.size());
        EXPECT_EQ(few.front(), way.front());
        EXPECT_EQ(few.back(), way.back());
        for (const tracking::Waypoint& point : way) {
            const auto [there, down] = place_at(few, point.time);
            EXPECT_LE(std::hypot(there - point.x, down - point.y), 12 + 1e-9);
        }
    }
}

TEST(Way, KeepsAStayAndAStraightWayInFewPoints) {
    std::vector<tracking::Waypoint> way;
    for (int k = 0; k <= 100; ++k) way.push_back({k, k < 50 ? 10 * k : 500, 100});
    const std::vector<tracking::Waypoint> few = tracking::simplified(way, 2);
    EXPECT_EQ(few, (std::vector<tracking::Waypoint>{{0, 0, 100}, {50, 500, 100}, {100, 500, 100}}));
    EXPECT_EQ(tracking::simplified({}, 2).size(), 0U);
    EXPECT_EQ(tracking::simplified(std::vector<tracking::Waypoint>{{1, 2, 3}}, 2).size(), 1U);
    const std::vector<tracking::Waypoint> one_time{{5, 0, 0}, {5, 900, 0}, {5, 0, 0}};
    EXPECT_EQ(tracking::simplified(one_time, 2).size(), 3U);
}

TEST(Way, IsAsExactAsAReport) {
    // Pages know more digits than reports, and have the same ways.
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, 1000);
    const auto told = [](double value) { return std::round(value * 1000) / 1000; };
    for (int k = 0; k < 10'000; ++k) {
        const glm::dvec2 place(anywhere(random), anywhere(random));
        const double seconds = anywhere(random);
        EXPECT_EQ(tracking::waypoint(seconds, place, {768, 576}),
                  tracking::waypoint(told(seconds), {told(place.x), told(place.y)}, {768, 576}));
    }
    EXPECT_EQ(tracking::waypoint(1.25, {191.5, 287.5}, {768, 576}), (tracking::Waypoint{13, 250, 500}));
}

constexpr Size field{384, 288};
constexpr int most = 384 / 8;

tracking::Event event_in(const PixelBox& box) {
    tracking::Event event;
    event.box = box;
    return event;
}

/// `count` small events side by side from a place on.
std::vector<tracking::Event> small_events(int count, int left, int top, int step) {
    std::vector<tracking::Event> events;
    for (int k = 0; k < count; ++k) {
        const int x = left + step * (k % 4);
        const int y = top + step * (k / 4);
        events.push_back(event_in({x, y, x + 10, y + 12}));
    }
    return events;
}

void add(std::vector<tracking::Event>& events, int count, const PixelBox& box) {
    for (int k = 0; k < count; ++k) events.push_back(event_in(box));
}

TEST(Clutter, ADozenInOnePartDominate) {
    std::vector<tracking::Event> events = small_events(12, 250, 20, 20);
    add(events, 12, {0, 100, 384, 160});
    const auto scraps = tracking::find_clutter(events, field);
    ASSERT_TRUE(scraps);
    EXPECT_EQ(scraps->count, 12);
    EXPECT_EQ(scraps->box, (PixelBox{250, 20, 320, 72}));
}

TEST(Clutter, FewerThanADozenAreFew) {
    EXPECT_FALSE(tracking::find_clutter(small_events(11, 250, 20, 20), field));
    EXPECT_FALSE(tracking::find_clutter({}, field));
}

TEST(Clutter, LessThanHalfOfAllEventsDoNotDominate) {
    std::vector<tracking::Event> events = small_events(12, 250, 20, 20);
    add(events, 13, {0, 100, 384, 160});
    EXPECT_FALSE(tracking::find_clutter(events, field));
}

TEST(Clutter, ThoseOfAllPartsOfThePictureAreLeftAlone) {
    // Far people walk everywhere: no region is without them.
    std::vector<tracking::Event> events;
    for (int k = 0; k < 40; ++k) {
        const int x = 36 * (k % 10);
        const int y = 70 * (k / 10);
        events.push_back(event_in({x, y, x + 10, y + 12}));
    }
    EXPECT_FALSE(tracking::find_clutter(events, field));
}

TEST(Clutter, WhatGoesFarIsNone) {
    std::vector<tracking::Event> events;
    add(events, 30, {200, 20, 200 + most, 20 + most});
    EXPECT_TRUE(tracking::find_clutter(events, field));
    events.clear();
    add(events, 30, {200, 20, 200 + most + 1, 30});
    EXPECT_FALSE(tracking::find_clutter(events, field));
}

TEST(Events, AreBusyWhereTheyMove) {
    using Times = std::vector<std::pair<double, double>>;
    const auto at = [](double seconds) { return Moment{std::llround(25 * seconds), seconds}; };
    const auto stay = [&](double first, double last) { return tracking::Stay{at(first), at(last), {}, {}}; };
    tracking::Event event;
    event.first = at(10);
    event.last = at(200);
    EXPECT_EQ(tracking::busy_times(std::vector{event}), (Times{{10, 200}}));
    event.stays = {stay(20, 70)};
    EXPECT_EQ(tracking::busy_times(std::vector{event}), (Times{{10, 200}})) << "who waits may do something";
    event.stays = {stay(20, 90), stay(100, 120)};
    EXPECT_EQ(tracking::busy_times(std::vector{event}), (Times{{10, 21}, {89, 200}})) << "as a parked car";
    event.kind = tracking::EventKind::left;
    event.stays = {stay(10, 200)};
    EXPECT_EQ(tracking::busy_times(std::vector{event}), (Times{{10, 11}, {199, 200}}));
}

}  // namespace
}  // namespace vvr
