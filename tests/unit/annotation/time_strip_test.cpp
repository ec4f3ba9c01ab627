#include "core/annotation/time_strip.h"

#include <algorithm>
#include <cstddef>
#include <random>

#include <gtest/gtest.h>

namespace vvr {
namespace {

tracking::Event event_of(double first, double last) {
    tracking::Event event;
    event.first = {static_cast<std::int64_t>(first * 10), first};
    event.last = {static_cast<std::int64_t>(last * 10), last};
    return event;
}

/// Of up to 20 s each.
std::vector<tracking::Event> random_events(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> time(0, 100);
    std::vector<tracking::Event> events;
    for (int i = 0; i < count; ++i) {
        const double first = time(random);
        events.push_back(event_of(first, first + time(random) / 5));
    }
    return events;
}

TEST(StripBars, OfOneRowAreNotThereAtTheSameTime) {
    std::mt19937 random(5);
    for (int round = 0; round < 100; ++round) {
        const std::vector<tracking::Event> events = random_events(60, random);
        const std::vector<std::size_t> order = annotation::by_importance(events);
        const std::vector<annotation::StripBar> bars = annotation::strip_bars(events, order, 8, 2);
        EXPECT_GE(bars.size(), 8U);
        for (const annotation::StripBar& a : bars) {
            EXPECT_LT(a.row, 8);
            for (const annotation::StripBar& b : bars) {
                if (a.event == b.event || a.row != b.row) continue;
                EXPECT_TRUE(events[a.event].first.seconds >= events[b.event].last.seconds + 2 ||
                            events[b.event].first.seconds >= events[a.event].last.seconds + 2);
            }
        }
    }
}

TEST(StripBars, WithoutRoomAreNone) {
    const std::vector<tracking::Event> events{event_of(0, 5)};
    EXPECT_TRUE(annotation::strip_bars(events, annotation::by_importance(events), 0, 1).empty());
}

// As many rows as there are objects at once are enough for all of them.
TEST(StripBars, OfAllObjectsFitIfThereAreAsManyRowsAsObjectsAtOnce) {
    std::mt19937 random(9);
    for (int round = 0; round < 100; ++round) {
        const std::vector<tracking::Event> events = random_events(40, random);
        std::ptrdiff_t at_once = 0;
        for (const tracking::Event& event : events) {
            const auto is_there = [&](const tracking::Event& other) {
                return other.first.seconds <= event.first.seconds && event.first.seconds < other.last.seconds + 2;
            };
            at_once = std::max(at_once, std::ranges::count_if(events, is_there));
        }
        const std::vector<std::size_t> order = annotation::by_importance(events);
        EXPECT_EQ(annotation::strip_bars(events, order, static_cast<int>(at_once), 2).size(), events.size()) << round;
        EXPECT_LT(annotation::strip_bars(events, order, static_cast<int>(at_once) - 1, 2).size(), events.size())
            << round;
    }
}

TEST(StripBars, AreOfTheMostImportantIfNotAllFit) {
    const std::vector<tracking::Event> events{event_of(0, 10), event_of(1, 30), event_of(2, 12), event_of(20, 25)};
    const std::vector<annotation::StripBar> bars =
        annotation::strip_bars(events, annotation::by_importance(events), 2, 1);
    ASSERT_EQ(bars.size(), 3U);
    EXPECT_EQ(bars[0].event, 0U);
    EXPECT_EQ(bars[1].event, 1U);
    EXPECT_EQ(bars[2].event, 3U);
}

TEST(IdlePeriods, AreTheRestOfTheClip) {
    const std::vector<annotation::Period> idle = annotation::idle_periods({{5, 8}, {3, 20}, {30, 40}}, 0, 50);
    ASSERT_EQ(idle.size(), 3U);
    EXPECT_EQ(idle[0].begin, 0);
    EXPECT_EQ(idle[0].end, 3);
    EXPECT_EQ(idle[1].begin, 20);
    EXPECT_EQ(idle[1].end, 30);
    EXPECT_EQ(idle[2].begin, 40);
    EXPECT_EQ(idle[2].end, 50);
    EXPECT_EQ(annotation::idle_periods({}, 0, 50).size(), 1U);
    EXPECT_TRUE(annotation::idle_periods({{0, 50}}, 0, 50).empty());
}

/// A hundred frames, ten per second. In some of them, every `each`-th pixel of a square differs from the empty scene.
volume::Volume changed_in(int first, int last, int each) {
    constexpr Size size{96, 64};
    volume::Volume volume(size, {.keep_owners = true});
    for (int i = 0; i < 100; ++i) {
        fields::Field field{i, i / 10.0, Plane<std::uint8_t>(size), {}, {}};
        for (int k = 0; k < 16 * 16 && i >= first && i <= last; k += each)
            field.scalar.at(20 + k % 16, 20 + k / 16) = 200;
        volume.add(field);
    }
    return volume;
}

TEST(UnexplainedPeriods, AreThoseWithAThingThatIsNoObject) {
    const std::vector<annotation::Period> periods =
        annotation::unexplained_periods(changed_in(30, 49, 1), volume::no_styles);
    ASSERT_EQ(periods.size(), 1U);
    EXPECT_NEAR(periods[0].begin, 3, 1e-9);
    EXPECT_NEAR(periods[0].end, 5, 1e-9);
}

TEST(UnexplainedPeriods, AreThoseWithoutFramesToo) {
    volume::Volume volume = changed_in(100, 100, 1);
    volume.add_gap(100, 30, 10, 0.1);
    volume.add({130, 13, Plane<std::uint8_t>(volume.size()), {}, {}});
    const std::vector<annotation::Period> periods = annotation::unexplained_periods(volume, volume::no_styles);
    ASSERT_EQ(periods.size(), 1U);
    EXPECT_NEAR(periods[0].begin, 10, 1e-9);
    EXPECT_NEAR(periods[0].end, 13, 1e-9);
}

TEST(UnexplainedPeriods, DoNotCountNoiseAndFlashes) {
    EXPECT_TRUE(annotation::unexplained_periods(changed_in(30, 49, 7), volume::no_styles).empty());
    EXPECT_TRUE(annotation::unexplained_periods(changed_in(30, 34, 1), volume::no_styles).empty());
}

}  // namespace
}  // namespace vvr
