#include "core/annotation/objects.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace vvr {
namespace {

Moment at(double seconds) {
    return {static_cast<std::int64_t>(seconds * 10), seconds};
}

tracking::Event event_of(tracking::EventKind kind, double first, double last) {
    tracking::Event event;
    event.kind = kind;
    event.first = at(first);
    event.last = at(last);
    event.path = {{at(first), {10, 20}}, {at(last), {30, 40}}};
    return event;
}

TEST(MostTelling, WhatWasLeftOrTakenThenTheLongest) {
    std::vector<tracking::Event> events{
        event_of(tracking::EventKind::moved, 0, 60), event_of(tracking::EventKind::moved, 0, 10),
        event_of(tracking::EventKind::left, 5, 9), event_of(tracking::EventKind::taken, 5, 30),
        event_of(tracking::EventKind::stood, 0, 30)};
    events[4].stays.push_back({at(5), at(20), {10, 20}, {}});
    EXPECT_EQ(annotation::by_importance(events), (std::vector<std::size_t>{3, 2, 4, 0, 1}));
    EXPECT_TRUE(annotation::by_importance({}).empty());
}

TEST(MostTelling, TheSlowestAndTheLargestAreAmongTheFirst) {
    std::vector<tracking::Event> events;
    for (int k = 0; k < 12; ++k) events.push_back(event_of(tracking::EventKind::left, k, k + 20));
    for (int k = 0; k < 12; ++k) events.push_back(event_of(tracking::EventKind::moved, k, k + 10 + k));
    const std::size_t largest = 12;
    const std::size_t slowest = 15;
    for (std::size_t k = 0; k < events.size(); ++k)
        events[k].portrait = tracking::Portrait{events[k].first, {0, 0, 10, k == largest ? 30 : 20}, 1};
    events[slowest].stays.push_back({at(5), at(15), {10, 20}, {}});
    const std::vector<std::size_t> order = annotation::by_importance(events);
    EXPECT_EQ(std::vector(order.begin() + 3, order.begin() + 5), (std::vector{slowest, largest}));
    EXPECT_EQ(std::set(order.begin(), order.end()).size(), events.size());
}

TEST(PlaceAt, IsOnThePath) {
    const tracking::Event event = event_of(tracking::EventKind::moved, 2, 4);
    EXPECT_EQ(annotation::position_at(event, 2.5), glm::dvec2(15, 25));
    EXPECT_EQ(annotation::position_at(event, 0), glm::dvec2(10, 20));
    EXPECT_EQ(annotation::position_at(event, 9), glm::dvec2(30, 40));
}

TEST(PlaceAt, OfNoPathIsTheMiddle) {
    tracking::Event event = event_of(tracking::EventKind::left, 2, 4);
    event.path.clear();
    event.box = {10, 20, 21, 41};
    EXPECT_EQ(annotation::position_at(event, 3), glm::dvec2(15, 30));
}

TEST(Words, SayWhatItDidAndWhen) {
    tracking::Event event = event_of(tracking::EventKind::stood, 6, 28.4);
    event.stays.push_back({at(7), at(8), {}, {}});
    event.stays.push_back({at(10), at(24), {}, {}});
    EXPECT_EQ(annotation::activity_texts(event).front(), "stayed 15 s in all");
    EXPECT_EQ(annotation::time_texts(event, 60, {}).front(), "0:06–0:28");
    EXPECT_EQ(annotation::time_texts(event, 60, {}, 2).front(), "0:06–0:28, then with 2");
    EXPECT_EQ(annotation::time_texts(event, 60, 1'795'248'017).front(), "08:00:23–08:00:45");
    Clock days(1'795'248'017);
    days.lasts = 3 * 86'400;
    EXPECT_EQ(annotation::time_texts(event, 60, days).front(), "Sat 08:00");
    event.last = at(128.4);
    EXPECT_EQ(annotation::time_texts(event, 60, days).front(), "Sat 08:00–08:02");
    event.last = at(90'000);
    EXPECT_EQ(annotation::time_texts(event, 60, days).front(), "Sat 08:00–Sun 09:00");
    days.lasts = 17 * 86'400;
    event.last = at(28.4);
    EXPECT_EQ(annotation::time_texts(event, 60, days).front(), "11-21 08:00");
    EXPECT_EQ(annotation::time_texts(event, event.last.seconds, {}).front(), "0:06–0:28")
        << "who walks is not there for long";
    event.kind = tracking::EventKind::left;
    EXPECT_EQ(annotation::time_texts(event, 60, {}).front(), "0:06–0:28");
    EXPECT_EQ(annotation::time_texts(event, event.last.seconds, {}).front(), "0:06–0:28") << "somebody fetched it";
    event.open_ended = true;
    EXPECT_EQ(annotation::time_texts(event, event.last.seconds, {}),
              (std::vector<std::string>{"0:06, still there", "from 0:06", "0:06"}));
    EXPECT_EQ(annotation::time_texts(event, 60, {}),
              (std::vector<std::string>{"0:06, still there at 0:28", "from 0:06", "0:06"}))
        << "a gap follows";
    EXPECT_EQ(annotation::activity_texts(event_of(tracking::EventKind::left, 0, 5)).front(), "left behind");
    EXPECT_EQ(annotation::activity_texts(event_of(tracking::EventKind::taken, 0, 5)).front(), "taken away");
    EXPECT_EQ(annotation::activity_texts(event_of(tracking::EventKind::moved, 0, 5)).front(), "went down and right");
    event = event_of(tracking::EventKind::moved, 0, 5);
    const glm::dvec2 begin = event.path.front().place;
    event.path = {{at(0), begin}, {at(2), begin + glm::dvec2(40, 0)}, {at(5), begin + glm::dvec2(2, 0)}};
    event.path_length = 78;
    EXPECT_EQ(annotation::activity_texts(event).front(), "to and fro");
    event.path = {
        {at(0), begin}, {at(1), begin + glm::dvec2(40, 0)}, {at(2), begin}, {at(3), begin + glm::dvec2(40, 0)}};
    event.path_length = 240;  // with more turns than these points
    EXPECT_EQ(annotation::activity_texts(event).front(), "went to the right") << "it paced, and left at the other side";
}

TEST(Words, SayWhatItIs) {
    tracking::Event event = event_of(tracking::EventKind::stood, 6, 28.4);
    event.stays.push_back({at(10), at(24), {}, {}});
    event.identity = {detector::find_class("person"), 0.9, 1};
    EXPECT_EQ(annotation::activity_texts(event),
              (std::vector<std::string>{"person · stayed 14 s", "person · stayed", "stayed 14 s", "stayed"}));
}

TEST(StandingTimes, OfWhatWasLeftAreAllOfItsTime) {
    tracking::Event event = event_of(tracking::EventKind::left, 5, 30);
    event.stays.push_back({at(9), at(20), {10, 20}, {}});
    ASSERT_EQ(annotation::stationary_times(event).size(), 1U);
    EXPECT_EQ(annotation::stationary_times(event)[0].first.seconds, 5);
    EXPECT_EQ(annotation::stationary_times(event)[0].last.seconds, 30);
    event.kind = tracking::EventKind::stood;
    EXPECT_EQ(annotation::stationary_times(event)[0].first.seconds, 9);
}

}  // namespace
}  // namespace vvr
