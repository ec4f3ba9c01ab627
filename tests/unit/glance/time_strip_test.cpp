#include "core/glance/time_strip.h"

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

TEST(QuietTimes, AreThoseInWhichNobodyIsThere) {
    const std::vector<events::Event> events{event_of(5, 20), event_of(3, 8), event_of(30, 40)};
    const std::vector<glance::IdlePeriod> quiet = glance::idle_periods(events, 0, 50);
    ASSERT_EQ(quiet.size(), 3U);
    EXPECT_EQ(quiet[0].begin, 0);
    EXPECT_EQ(quiet[0].end, 3);
    EXPECT_EQ(quiet[1].begin, 20);
    EXPECT_EQ(quiet[1].end, 30);
    EXPECT_EQ(quiet[2].begin, 40);
    EXPECT_EQ(quiet[2].end, 50);
    EXPECT_EQ(glance::idle_periods({}, 0, 50).size(), 1U);
    EXPECT_TRUE(glance::idle_periods(std::vector{event_of(0, 50)}, 0, 50).empty());
}

}  // namespace
}  // namespace vvr
