#include "core/glance/time_strip.h"

#include <algorithm>
#include <cstddef>
#include <random>

#include <gtest/gtest.h>

namespace vvr {
namespace {

events::Event event_of(double first, double last) {
    events::Event event;
    event.first = {static_cast<std::int64_t>(first * 10), first};
    event.last = {static_cast<std::int64_t>(last * 10), last};
    return event;
}

TEST(StripBars, OfOneRowAreNotThereAtTheSameTime) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> time(0, 100);
    for (int round = 0; round < 100; ++round) {
        std::vector<events::Event> events;
        for (int i = 0; i < 60; ++i) {
            const double first = time(random);
            events.push_back(event_of(first, first + time(random) / 5));
        }
        const std::vector<std::size_t> order = glance::by_importance(events);
        const std::vector<glance::StripBar> bars = glance::strip_bars(events, order, 8, 2);
        EXPECT_GE(bars.size(), 8U);
        for (const glance::StripBar& a : bars) {
            EXPECT_LT(a.row, 8);
            for (const glance::StripBar& b : bars) {
                if (a.event == b.event || a.row != b.row) continue;
                EXPECT_TRUE(events[a.event].first.seconds >= events[b.event].last.seconds + 2 ||
                            events[b.event].first.seconds >= events[a.event].last.seconds + 2);
            }
        }
    }
}

TEST(StripBars, WithoutRoomAreNone) {
    const std::vector<events::Event> events{event_of(0, 5)};
    EXPECT_TRUE(glance::strip_bars(events, glance::by_importance(events), 0, 1).empty());
}

// As many rows as there are objects at once are enough for all of them.
TEST(StripBars, OfAllObjectsFitIfThereAreAsManyRowsAsObjectsAtOnce) {
    std::mt19937 random(9);
    std::uniform_real_distribution<double> time(0, 100);
    for (int round = 0; round < 100; ++round) {
        std::vector<events::Event> events;
        for (int i = 0; i < 40; ++i) {
            const double first = time(random);
            events.push_back(event_of(first, first + time(random) / 5));
        }
        std::ptrdiff_t at_once = 0;
        for (const events::Event& event : events) {
            const auto is_there = [&](const events::Event& other) {
                return other.first.seconds <= event.first.seconds && event.first.seconds < other.last.seconds + 2;
            };
            at_once = std::max(at_once, std::ranges::count_if(events, is_there));
        }
        const std::vector<std::size_t> order = glance::by_importance(events);
        EXPECT_EQ(glance::strip_bars(events, order, static_cast<int>(at_once), 2).size(), events.size()) << round;
        EXPECT_LT(glance::strip_bars(events, order, static_cast<int>(at_once) - 1, 2).size(), events.size()) << round;
    }
}

TEST(StripBars, AreOfTheMostImportantIfNotAllFit) {
    const std::vector<events::Event> events{event_of(0, 10), event_of(1, 30), event_of(2, 12), event_of(20, 25)};
    const std::vector<glance::StripBar> bars = glance::strip_bars(events, glance::by_importance(events), 2, 1);
    ASSERT_EQ(bars.size(), 3U);
    EXPECT_EQ(bars[0].event, 0U);
    EXPECT_EQ(bars[1].event, 1U);
    EXPECT_EQ(bars[2].event, 3U);
}

}  // namespace
}  // namespace vvr
